#include "sim/study/two_rate_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace moontrace {
namespace {

// Training-and-ux 1.7, item 4, computed there independently: 120 trials at demand 1, 17 at -1, then
// an error clamp, in which the net output rebounds.
TEST(TwoRateMemory, RecoversSpontaneouslyAfterReversal) {
  const TwoRates rates;
  TwoRateMemory memory;
  for (int i = 0; i < 120; ++i) memory = AfterTrial(rates, memory, 1 - memory.total());
  EXPECT_NEAR(memory.total(), 0.720, 5e-4);
  for (int i = 0; i < 17; ++i) memory = AfterTrial(rates, memory, -1 - memory.total());
  EXPECT_NEAR(memory.total(), -0.219, 5e-4);
  double peak = -1;
  int at = 0;
  for (int i = 1; i <= 40; ++i) {
    memory = AfterTrial(rates, memory, 0);
    if (memory.total() > peak) {
      peak = memory.total();
      at = i;
    }
  }
  EXPECT_NEAR(peak, 0.179, 5e-4);
  EXPECT_EQ(at, 10);
}

TEST(TwoRateMemory, KeepsTheSlowPartOverDays) {
  const TwoRates rates;
  const TwoRateMemory after = AfterDays(rates, {0.5, 0.2}, 7);
  EXPECT_NEAR(after.slow, 0.5 * std::exp(-7.0 / 60), 1e-12);
  EXPECT_LT(after.fast, 1e-9);
}

TEST(TwoRateMemory, NoTimeChangesNothing) {
  const TwoRateMemory after = AfterDays({}, {0.5, 0.2}, 0);
  EXPECT_EQ(after.slow, 0.5);
  EXPECT_EQ(after.fast, 0.2);
}

}  // namespace
}  // namespace moontrace
