#include "sim/study/size_threshold.h"

#include <cmath>
#include <stdexcept>

#include "lessons/progress/item_choice.h"
#include "sim/study/item_page.h"

namespace moontrace {

SizeThreshold FindSizeThreshold(SimulatedLearner& learner, const Script& script,
                                const std::vector<std::string>& items, const StaircaseRule& rule,
                                std::size_t staircases, std::uint64_t seed) {
  if (items.empty() || staircases == 0) {
    throw std::invalid_argument("size threshold: nothing to ask for");
  }
  std::vector<Staircase> stairs(staircases, Staircase(rule));
  SizeThreshold found;
  while (const std::optional<std::size_t> next = NextStaircase(stairs, seed)) {
    const std::string& item = items[NextRandom(seed) % items.size()];
    const ItemPage page = SetItem(item, script, stairs[*next].level());
    const FeltShape felt = learner.Feel(page);
    const bool right = learner.shapes().Name(felt, learner.day(), learner.Guess()).label == item;
    stairs[*next].Add(right);
    ++found.trials;
    if (right) ++found.right;
  }
  double logs = 0;
  std::size_t turned = 0;
  for (const Staircase& staircase : stairs) {
    const std::optional<double> size = staircase.Threshold();
    if (!size) continue;
    logs += std::log(*size);
    ++turned;
  }
  if (turned > 0) found.size = std::exp(logs / static_cast<double>(turned));
  return found;
}

}  // namespace moontrace
