#include "sim/loop/histogram.h"

#include <gtest/gtest.h>

#include <vector>

#include "textures/base/random.h"

namespace moontrace {
namespace {

TEST(Histogram, AgreesWithSortedData) {
  Random random(7);
  Histogram histogram;
  std::vector<double> all;
  for (int i = 0; i < 100000; ++i) {
    // from nanoseconds to seconds, evenly in the logarithm
    const double us = std::exp(std::log(1e-3) + random.Uniform() * std::log(1e9));
    histogram.Add(us);
    all.push_back(us);
  }
  std::sort(all.begin(), all.end());
  EXPECT_EQ(histogram.count(), all.size());
  EXPECT_DOUBLE_EQ(histogram.max(), all.back());
  for (const double p : {0.001, 0.25, 0.5, 0.9, 0.99, 0.999, 1.0}) {
    const double exact =
        all[static_cast<std::size_t>(std::ceil(p * static_cast<double>(all.size()))) - 1];
    const double told = histogram.Percentile(p);
    EXPECT_GE(told, exact - 1e-3) << p;  // whole nanoseconds
    EXPECT_LE(told, exact * (1 + 1.0 / 64) + 1e-3) << p;
  }
}

TEST(Histogram, OfNothingIsZero) {
  const Histogram histogram;
  EXPECT_EQ(histogram.Percentile(0.5), 0);
  EXPECT_EQ(histogram.max(), 0);
}

TEST(Histogram, TakesWhatIsNoDuration) {
  Histogram histogram;
  histogram.Add(-1);
  histogram.Add(NAN);
  histogram.Add(INFINITY);
  EXPECT_EQ(histogram.count(), 3U);
  EXPECT_EQ(histogram.Percentile(0.5), 0);
  EXPECT_NEAR(histogram.max(), 1099511627.775, 1e-3);  // 2^40 ns
}

}  // namespace
}  // namespace moontrace
