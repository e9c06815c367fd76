#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "sim/console/console.h"
#include "sim/library/handles.h"
#include "sim/library/stepping/bound_scene.h"
#include "sim/setup/text_setup.h"
#include "sim/trial/trial_result.h"

namespace moontrace {

/// What stands behind the handles of the interface to MuJoCo.

struct SceneState {
  SceneState(mjModel_* m, mjData_* d, std::string xml) : bound(m, d, std::move(xml)) {}
  BoundScene bound;
  TextSetup text;
  std::size_t page = 0;                       ///< of the text
  std::shared_ptr<const TextureField> field;  ///< of the page
  std::string remarks;
  bool records = false;  ///< it is known what the model was made of
  std::atomic<bool> in_use{false};
};
struct SceneValue {
  std::unique_ptr<SceneState> state;
};

/// A trace that was made: nothing changes it.
struct TraceValue {
  TrialResult result;
  std::string json;
  std::vector<double> time, tip, proxy, force, depth;  ///< as moontrace_trace_samples has them
};

using SceneTable = HandleTable<SceneValue, 4>;
using TraceTable = HandleTable<TraceValue, 5>;

/// In messages.
inline constexpr const char* kSceneHandle = "scene";
inline constexpr const char* kTraceHandle = "trace";

/// Keeps a scene to one thread. Throws UsageError where another one is in it.
class Alone {
 public:
  explicit Alone(SceneState& state) : state_(state) {
    if (state_.in_use.exchange(true, std::memory_order_acquire)) {
      throw UsageError("another thread is in a call with this scene");
    }
  }
  ~Alone() { state_.in_use.store(false, std::memory_order_release); }
  Alone(const Alone&) = delete;
  Alone& operator=(const Alone&) = delete;

 private:
  SceneState& state_;
};

}  // namespace moontrace
