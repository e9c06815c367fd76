#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "sim/setup/options.h"
#include "sim/setup/text_setup.h"
#include "sim/trial/trial.h"

namespace moontrace {

/// How a simulated hand presses on letters of this relief, and on ridges among them: as asked [N],
/// else as that hand does.
void SetPress(const HandModel& hand, Relief relief, std::optional<double> press,
              PlanOptions& options);

/// The shipped hand on one page of a text, as the command line has it; refers to `text`, which must
/// outlive it. Speed, push, pictures and watchers are the caller's to set.
TrialSetup TrialOf(const TextSetup& text, std::size_t page, const FeelOptions& feel,
                   std::optional<double> press, std::uint64_t seed);

}  // namespace moontrace
