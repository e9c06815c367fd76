#pragma once

/// @file
/// Moontrace on models of a MuJoCo of your own, for C++17 and later: moontrace_mujoco.h with
/// handles that close themselves and refusals that are thrown. It keeps to the rules of that
/// header: one thread at a time for a scene, and for all scenes of one model; close a scene before
/// its model or data are deleted.
///
///     moontrace::SceneOptions options(mjVERSION_HEADER);
///     moontrace::Scene scene(m, d, options);
///     while (...) {
///       const moontrace::Felt felt = scene.Step({x, y, z});   // in place of mj_step(m, d)
///     }

#include <moontrace_mujoco.h>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <moontrace.hpp>

namespace moontrace {
inline namespace library_1 {

/// Throws Error for any answer but MOONTRACE_DONE.
inline void RequireScene(int answer) {
  if (answer != MOONTRACE_DONE) throw Error(answer, moontrace_scene_message());
}

/// The fields of moontrace_scene_options; zero and null are what is usual.
struct SceneOptions : moontrace_scene_options {
  /// Of mjVERSION_HEADER.
  explicit SceneOptions(int mujoco_header) : moontrace_scene_options{} {
    size = sizeof(moontrace_scene_options);
    mujoco = mujoco_header;
  }
};

/// What a step gave: the fields of moontrace_scene_answer.
struct Felt : moontrace_scene_answer {
  Felt() : moontrace_scene_answer{} { size = sizeof(moontrace_scene_answer); }
};

/// How a page is traced: the fields of moontrace_trace_options.
struct TraceOptions : moontrace_trace_options {
  TraceOptions() : moontrace_trace_options{} { size = sizeof(moontrace_trace_options); }
};

class Trace;

/// A place or a velocity [m, m/s].
using Vector = std::array<double, 3>;

/// A model that carries text, bound to its data, which both stay the caller's.
class Scene {
 public:
  /// Throws Error where moontrace_scene_open refuses.
  Scene(mjModel_* m, mjData_* d, const SceneOptions& options) : m_(m), d_(d) {
    RequireScene(moontrace_scene_check(MOONTRACE_MUJOCO_INTERFACE, options.mujoco));
    moontrace_scene* scene = nullptr;
    RequireScene(moontrace_scene_open(m, d, &options, &scene));
    handle_.reset(scene);
  }
  /// Its strings live as long as the scene.
  moontrace_scene_facts facts() const {
    auto facts = Sized<moontrace_scene_facts>();
    RequireScene(moontrace_scene_describe(get(), &facts));
    return facts;
  }

  /// One step, in place of mj_step, with the tip at that place of the world. Allocates nothing.
  /// Throws Error: places that are not finite, an error within MuJoCo, a step with a fault.
  Felt Step(const Vector& position_W) {
    auto input = Sized<moontrace_scene_input>();
    for (std::size_t i = 0; i < 3; ++i) input.position[i] = position_W[i];
    return Give(input);
  }
  Felt Step(const Vector& position_W, const Vector& velocity_W) {
    auto input = Sized<moontrace_scene_input>();
    for (std::size_t i = 0; i < 3; ++i) input.position[i] = position_W[i];
    for (std::size_t i = 0; i < 3; ++i) input.velocity[i] = velocity_W[i];
    input.velocity_known = 1;
    return Give(input);
  }
  /// Resets the data; the proxy rests at a place over the page, P.
  void Reset(const Vector& tip_P) {
    RequireScene(moontrace_scene_reset(get(), m_, d_, tip_P.data()));
  }
  /// Where a place over the page lies in the world now.
  Vector PlaceOf(const Vector& place_P) const {
    Vector world{};
    RequireScene(moontrace_scene_place(get(), m_, d_, place_P.data(), world.data()));
    return world;
  }
  moontrace_scene* get() const noexcept { return handle_.get(); }

 private:
  friend class Trace;
  struct Close {
    void operator()(moontrace_scene* scene) const noexcept { moontrace_scene_close(scene); }
  };
  Felt Give(const moontrace_scene_input& input) {
    Felt felt;
    RequireScene(moontrace_scene_step(get(), m_, d_, &input, &felt));
    return felt;
  }

  mjModel_* m_;
  mjData_* d_;
  std::unique_ptr<moontrace_scene, Close> handle_;
};

/// A trace of a scene's page by a simulated hand. Needs the scene no more once it is made.
class Trace {
 public:
  /// Throws Error where moontrace_trace_open refuses.
  explicit Trace(Scene& scene, const TraceOptions& options = {}) {
    moontrace_trace* trace = nullptr;
    RequireScene(moontrace_trace_open(scene.get(), scene.m_, scene.d_, &options, &trace));
    handle_.reset(trace);
  }
  /// `json` lives as long as the trace.
  moontrace_trace_facts facts() const {
    auto facts = Sized<moontrace_trace_facts>();
    RequireScene(moontrace_trace_describe(get(), &facts));
    return facts;
  }
  /// The way of the tip over the page, P, one place a step.
  std::vector<Vector> tips() const {
    std::vector<Vector> tips(facts().samples);
    auto samples = Sized<moontrace_trace_samples>();
    samples.count = tips.size();
    samples.tip = tips.empty() ? nullptr : tips.front().data();
    RequireScene(moontrace_trace_read(get(), &samples));
    return tips;
  }
  moontrace_trace* get() const noexcept { return handle_.get(); }

 private:
  struct Close {
    void operator()(moontrace_trace* trace) const noexcept { moontrace_trace_close(trace); }
  };
  std::unique_ptr<moontrace_trace, Close> handle_;
};

}  // namespace library_1
}  // namespace moontrace
