#include "sim/study/two_rate_memory.h"

#include <cmath>

namespace moontrace {

TwoRateMemory AfterTrial(const TwoRates& rates, TwoRateMemory memory, double error) {
  return {rates.slow_retention * memory.slow + rates.slow_gain * error,
          rates.fast_retention * memory.fast + rates.fast_gain * error};
}

TwoRateMemory AfterDays(const TwoRates& rates, TwoRateMemory memory, double days) {
  return {memory.slow * std::exp(-days / rates.slow_days),
          memory.fast * std::exp(-days / rates.fast_days)};
}

}  // namespace moontrace
