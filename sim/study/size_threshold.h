#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/study/simulated_learner.h"
#include "sim/study/staircase.h"
#include "textures/fonts/script.h"

namespace moontrace {

/// How small letters may be that a learner still knows by touch.
struct SizeThreshold {
  /// Geometric mean of the staircases' thresholds [m]; none where no staircase turned often enough:
  /// all was known at the least size, or nothing at the greatest.
  std::optional<double> size;
  std::size_t trials = 0;
  std::size_t right = 0;
};

/// Asks a learner for items by interleaved staircases over their size (staircase.h; the rule's
/// levels are sizes [m]). Unguided, and the learner is not told what it was, so that asking teaches
/// nothing. Items are drawn by chance; it should have been told of all of them before. The same
/// learner, rule and seed give the same answer. Throws as SetItem and Staircase;
/// std::invalid_argument without items or staircases.
SizeThreshold FindSizeThreshold(SimulatedLearner& learner, const Script& script,
                                const std::vector<std::string>& items, const StaircaseRule& rule,
                                std::size_t staircases, std::uint64_t seed);

}  // namespace moontrace
