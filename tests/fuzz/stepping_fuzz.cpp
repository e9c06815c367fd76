// Any bytes as calls of the C interface to MuJoCo, on a model and data of the caller's whose state
// the bytes change too: each call answers by a code, with a sentence if it refuses; forces are
// finite, and the model is the caller's again after each.
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

#include "sim/library/stepping/moontrace_mujoco.h"
#include "tests/fuzz/memory_file.h"

namespace {

constexpr const char* kModel =
    "<mujoco><custom><text name='moontrace:page' data='{}'/>"
    "<text name='moontrace:cup' data=\"{text='I', size_mm=8}\"/></custom>"
    "<worldbody><geom name='page' type='plane' size='.1 .1 .1' contype='0' conaffinity='0'/>"
    "<body pos='.3 0 0'><freejoint/><geom name='cup' type='cylinder' size='.03 .04' mass='.2'/>"
    "</body><body name='moontrace_proxy'>"
    "<inertial pos='0 0 0' mass='.05' diaginertia='1e-6 1e-6 1e-6'/>"
    "<joint type='slide' axis='1 0 0'/><joint type='slide' axis='0 1 0'/>"
    "<joint type='slide' axis='0 0 1'/></body></worldbody></mujoco>";

void Require(bool holds) {
  if (!holds) std::abort();
}

/// Made once: models and data of all inputs.
struct Model {
  Model() {
    mju_user_warning = [](const char*) {};
    const moontrace::MemoryFile file(kModel);
    char error[300];
    m = mj_loadXML(file.path().c_str(), nullptr, error, sizeof error);
    Require(m != nullptr);
    d = mj_makeData(m);
    other = mj_makeData(m);
  }
  mjModel* m = nullptr;
  mjData *d = nullptr, *other = nullptr;
};

class Caller {
 public:
  Caller(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {
    mj_resetData(model_.m, model_.d);
  }
  ~Caller() {
    for (moontrace_scene* scene : scenes_) moontrace_scene_close(scene);
  }
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;

  void Run() {
    for (int calls = 0; calls < 48 && size_ > 0; ++calls) {
      Call();
      Require(model_.m->opt.timestep == 0.002 && model_.m->opt.disableflags == 0);
    }
  }

 private:
  template <class Value>
  Value Take() {
    Value value{};
    const std::size_t count = std::min(sizeof value, size_);
    std::memcpy(&value, data_, count);
    data_ += count;
    size_ -= count;
    return value;
  }
  /// Mostly near the page, at times any bits.
  double Number() {
    const auto kind = Take<std::uint8_t>();
    return kind < 16 ? Take<double>() : 0.001 * (kind - 100);
  }
  moontrace_scene*& Scene() { return scenes_[Take<std::uint8_t>() % scenes_.size()]; }
  template <class Struct>
  void Size(Struct& given) {
    const auto byte = Take<std::uint8_t>();
    given.size = byte < 240 ? sizeof given : byte % sizeof given;
  }
  static void Answered(int code) {
    Require(code >= MOONTRACE_DONE && code <= MOONTRACE_WRONG_MUJOCO && code != MOONTRACE_FAULT);
    if (code != MOONTRACE_DONE) Require(moontrace_scene_message()[0] != '\0');
  }

  void Open() {
    moontrace_scene_options options{};
    Size(options);
    const auto flags = Take<std::uint8_t>();
    options.mujoco = (flags & 31) == 31 ? Take<std::int32_t>() : mjVERSION_HEADER;
    const char* const texts[] = {"i", "moon", nullptr, ""};
    options.text = texts[flags >> 5 & 3];
    options.direct = flags & 1;
    options.law = flags >> 1 & 1;
    options.label = flags >> 2 & 1;
    if (flags & 8) options.stiffness = Number();
    if (flags & 16) options.friction = Number();
    if (flags & 128) options.coupling_stiffness = 1e6 * Number();
    moontrace_scene* scene = nullptr;
    Answered(moontrace_scene_open(model_.m, model_.d, &options, &scene));
    moontrace_scene*& to = Scene();
    moontrace_scene_close(to);
    to = scene;
  }

  void Step() {
    moontrace_scene_input input{};
    Size(input);
    moontrace_scene_answer felt{};
    Size(felt);
    for (double& value : input.position) value = Number();
    input.velocity_known = Take<std::uint8_t>() % 3;
    for (double& value : input.velocity) value = Number();
    mjData* const d = Take<std::uint8_t>() % 16 == 0 ? model_.other : model_.d;
    moontrace_scene* const scene = Scene();
    for (int i = Take<std::uint8_t>() % 8; i >= 0; --i) {
      Answered(moontrace_scene_step(scene, model_.m, d, &input, &felt));
      for (const double force : felt.force_world) Require(std::isfinite(force));
    }
  }

  void Call() {
    double three[3], world[3];
    switch (Take<std::uint8_t>() % 8) {
      case 0:
        return Open();
      case 1:
      case 2:
      case 3:
        return Step();
      case 4:
        for (double& value : three) value = Number();
        Answered(moontrace_scene_reset(Scene(), model_.m, model_.d, three));
        return Answered(moontrace_scene_place(Scene(), model_.m, model_.d, three, world));
      case 5:  // the caller does what it likes with its data
        model_.d->qpos[Take<std::uint8_t>() % model_.m->nq] = Number();
        model_.d->qvel[Take<std::uint8_t>() % model_.m->nv] = Number();
        return mj_forward(model_.m, model_.d);
      case 6: {
        moontrace_scene_facts facts{};
        Size(facts);
        return Answered(moontrace_scene_describe(Scene(), &facts));
      }
      default:  // closed, and held on to
        return Answered(moontrace_scene_close(Scene()));
    }
  }

  static inline Model model_;
  const std::uint8_t* data_;
  std::size_t size_;
  std::array<moontrace_scene*, 2> scenes_{};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Caller(data, size).Run();
  return 0;
}
