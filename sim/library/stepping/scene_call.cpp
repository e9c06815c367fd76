// The C interface to MuJoCo: scenes on a caller's model.
#include <fmt/core.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <string>

#include "sim/library/call.h"
#include "sim/library/stepping/moontrace_mujoco.h"
#include "sim/library/stepping/scene_text.h"
#include "sim/library/stepping/scene_values.h"
#include "sim/physics/mjcf.h"
#include "sim/physics/page_field.h"
#include "textures/base/error.h"
#include "textures/base/resources.h"
#include "textures/base/text_file.h"

using namespace moontrace;

namespace {

constexpr std::size_t kGreatestModel = std::size_t{64} << 20U;  // [bytes]

/// Empty: all three are the same.
std::string WrongMujoco(int callers) {
  const int running = mj_version();
  if (running == mjVERSION_HEADER && callers == mjVERSION_HEADER) return {};
  return fmt::format(
      "MuJoCo {} runs, the program was compiled for {}, this library for {}; take the library of "
      "that version",
      running, callers, mjVERSION_HEADER);
}

/// As Answer, once the versions of MuJoCo are known to agree.
template <class Body>
int AnswerFor(int callers_mujoco, Body&& body) noexcept {
  return Answer([&] {
    const std::string wrong = WrongMujoco(callers_mujoco);
    if (!wrong.empty()) throw AnswerError(MOONTRACE_WRONG_MUJOCO, wrong);
    body();
  });
}

/// What the model's file says, as a record keeps it.
std::string ExpandedXml(const char* path) {
  const std::string proxy = ReadTextFile(ResourcePath("models/proxy.xml"), kGreatestModel);
  const std::string folder = std::filesystem::absolute(path).parent_path().string();
  Mjcf mjcf = PrepareMjcf(ReadTextFile(path, kGreatestModel), folder, path, proxy);
  if (mjcf.proxy_inserted) {
    throw InputError(std::string(path) +
                     ": no body moontrace_proxy, so the model was not made of this file");
  }
  return std::move(mjcf.xml);
}

void SetIfAbove(double given, const char* name, double& value) {
  RequireNumber(given, name, 0);
  if (given > 0) value = given;
}

SceneOptions OptionsOf(const moontrace_scene_options& given) {
  SceneOptions options;
  options.label = given.label;
  if (RequireFlag(given.direct, "options.direct")) options.rendering = Rendering::kDirect;
  if (RequireFlag(given.law, "options.law")) options.surface.law = ForceLaw::kPaper;
  SetIfAbove(given.stiffness, "options.stiffness", options.surface.stiffness);
  SetIfAbove(given.force_cap, "options.force_cap", options.surface.force_cap);
  SetIfAbove(given.friction, "options.friction", options.friction);
  SetIfAbove(given.coupling_stiffness, "options.coupling_stiffness", options.coupling_stiffness);
  SetIfAbove(given.coupling_damping, "options.coupling_damping", options.coupling_damping);
  return options;
}

/// The labels' texts, as the program sets them.
void SetTexts(const moontrace_scene_options& given, const SceneOptions& options,
              SceneState& state) {
  TextRequest request;
  request.command = "scene";
  request.feel.scene = options;
  request.feel.model = given.model_path != nullptr ? given.model_path : "the model";
  request.model_page = ModelPageOf(state.bound.scene());
  if (given.text != nullptr) request.text.text = given.text;
  if (given.script != nullptr) request.style.script = given.script;
  if (given.style != nullptr) {
    SetStyle(Given(given.style, sizeof(moontrace_style), "style"), request);
  }
  std::istringstream nothing;
  std::ostringstream results, remarks;
  Console console(nothing, results, remarks);
  const auto unbroken = [] { return std::size_t{0}; };
  console.SetColumns(unbroken, unbroken);
  state.text = SetUpText(request, console);
  state.remarks = remarks.str();
}

std::unique_ptr<SceneState> OpenScene(mjModel* m, mjData* d, const moontrace_scene_options& given) {
  const bool records = given.model_path != nullptr;
  const SceneOptions options = OptionsOf(given);
  auto state =
      std::make_unique<SceneState>(m, d, records ? ExpandedXml(given.model_path) : std::string());
  state->records = records;
  BoundScene& bound = state->bound;
  bound.Bind(options);
  SetTexts(given, options, *state);
  const Typeset& set = state->text.set;
  if (given.page >= set.pages.size()) {
    throw UsageError(fmt::format("no page {}, the text has {}", given.page, set.pages.size()));
  }
  state->page = given.page;
  state->field = std::make_shared<const TextureField>(
      PageField(set.pages[given.page], state->text.script, set.style, false));
  // where the text lies on a round face is known only now
  bound.Bind(OnLabel(state->text, given.page, options));
  bound.RunWithout([&] {
    bound.scene().SetField(state->field.get());
    for (const LaidLabel& other : state->text.others) bound.scene().SetLabel(other);
  });
  for (const std::string& remark : bound.scene().remarks()) state->remarks += remark + '\n';
  if (!state->remarks.empty() && state->remarks.back() == '\n') state->remarks.pop_back();
  return state;
}

glm::dvec3 VectorOf(const double given[3], const char* name) {
  for (int i = 0; i < 3; ++i) RequireNumber(given[i], name);
  return {given[0], given[1], given[2]};
}

void Put(glm::dvec3 value, double* to) noexcept {
  for (int i = 0; i < 3; ++i) to[i] = value[i];
}

moontrace_scene_answer AnswerOf(const TickResult& result) noexcept {
  moontrace_scene_answer given{};
  given.in_contact = result.depth > 0 ? 1 : 0;
  given.through = result.through ? 1 : 0;
  given.fault = result.fault ? 1 : 0;
  Put(result.force_W, given.force_world);
  Put(result.force_P, given.force);
  Put(result.tip_P, given.tip);
  Put(result.proxy_P, given.proxy);
  Put(result.page_force_P, given.page_force);
  given.depth = result.depth;
  given.energy_out = result.energy_out;
  return given;
}

}  // namespace

int moontrace_scene_check(uint32_t interface_version, int mujoco) {
  return AnswerFor(mujoco, [&] {
    if (interface_version == 0 || interface_version > MOONTRACE_MUJOCO_INTERFACE) {
      throw UsageError(fmt::format("the program was made for interface {}, the library has {}",
                                   interface_version, MOONTRACE_MUJOCO_INTERFACE));
    }
  });
}

int moontrace_scene_mujoco(void) { return mjVERSION_HEADER; }

const char* moontrace_scene_message(void) { return LastMessage(); }

int moontrace_scene_open(mjModel_* m, mjData_* d, const moontrace_scene_options* options,
                         moontrace_scene** scene) {
  moontrace_scene_options given{};
  const int answer =
      Answer([&] { given = Given(options, sizeof(moontrace_scene_options), "options"); });
  if (answer != MOONTRACE_DONE) return answer;
  return AnswerFor(given.mujoco, [&] {
    RequireNotNull(m, "m");
    RequireNotNull(d, "d");
    RequireNotNull(scene, "scene");
    auto value = std::make_unique<SceneValue>();
    value->state = OpenScene(m, d, given);
    OpenHandle<SceneTable>(std::move(value), scene);
  });
}

int moontrace_scene_describe(const moontrace_scene* scene, moontrace_scene_facts* facts) {
  return Answer([&] {
    const InUse<SceneTable> value(scene, kSceneHandle);
    SceneState& state = *value->state;
    const Alone alone(state);
    const Scene& known = state.bound.scene();
    const Typeset& set = state.text.set;
    moontrace_scene_facts given{};
    given.mujoco = mjVERSION_HEADER;
    given.labels = known.labels().size();
    given.pages = set.pages.size();
    given.letters = set.pages[state.page].glyphs.size();
    given.substeps = static_cast<std::size_t>(known.substeps());
    given.tick = known.options().tick;
    given.width = set.page.width;
    given.height = set.page.height;
    given.proxy_mass = known.proxy_mass();
    given.force_bound = known.force_bound();
    given.carried_press = known.carried_press();
    given.text = state.text.text.c_str();
    given.remarks = state.remarks.c_str();
    Give(given, sizeof given, "facts", facts);
  });
}

int moontrace_scene_step(moontrace_scene* scene, mjModel_* m, mjData_* d,
                         const moontrace_scene_input* input, moontrace_scene_answer* answer) {
  return Answer([&] {
    Give(moontrace_scene_answer{}, sizeof *answer, "answer", answer);
    const InUse<SceneTable> value(scene, kSceneHandle);
    const moontrace_scene_input given = Given(input, sizeof *input, "input");
    SceneState& state = *value->state;
    const Alone alone(state);
    state.bound.Require(m, d);
    DeviceState hand;
    hand.p_D = VectorOf(given.position, "input.position");
    hand.velocity_known = RequireFlag(given.velocity_known, "input.velocity_known");
    if (hand.velocity_known) hand.v_D = VectorOf(given.velocity, "input.velocity");
    const TickResult result = state.bound.Tick(hand);
    Give(AnswerOf(result), sizeof *answer, "answer", answer);
    if (!result.fault) return;
    throw InputError(result.held ? "no force: something besides hand and page moves the proxy"
                                 : "no force: the model's state is not finite or too great");
  });
}

int moontrace_scene_reset(moontrace_scene* scene, mjModel_* m, mjData_* d, const double tip[3]) {
  return Answer([&] {
    RequireNotNull(tip, "tip");
    const InUse<SceneTable> value(scene, kSceneHandle);
    const Alone alone(*value->state);
    value->state->bound.Require(m, d);
    value->state->bound.Reset(VectorOf(tip, "tip"));
  });
}

int moontrace_scene_place(moontrace_scene* scene, mjModel_* m, mjData_* d, const double place[3],
                          double world[3]) {
  return Answer([&] {
    RequireNotNull(place, "place");
    RequireNotNull(world, "world");
    const InUse<SceneTable> value(scene, kSceneHandle);
    const Alone alone(*value->state);
    value->state->bound.Require(m, d);
    Put(value->state->bound.scene().PointOn(VectorOf(place, "place")).p_W, world);
  });
}

int moontrace_scene_close(moontrace_scene* scene) {
  return Answer([&] { CloseHandle<SceneTable>(scene, kSceneHandle); });
}
