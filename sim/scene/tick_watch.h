#pragma once

#include <functional>

#include "lessons/guide/guidance.h"
#include "sim/scene/scene_options.h"

namespace moontrace {

/// Is given each tick of a trial or replay, in its own time [s]: what was felt, and the push within
/// it. What it throws ends the trial.
using TickWatch =
    std::function<void(double time, const TickResult& felt, const GuidanceResult& push)>;

}  // namespace moontrace
