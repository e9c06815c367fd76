#include "textures/base/units.h"

#include <gtest/gtest.h>

#include <cmath>

namespace moontrace {
namespace {

TEST(Units, OfAnglesGoThereAndBack) {
  EXPECT_DOUBLE_EQ(InDegrees(kTurn), 360);
  EXPECT_DOUBLE_EQ(InDegrees(30 * kDegree), 30);
  EXPECT_NEAR(std::sin(30 * kDegree), 0.5, 1e-15);
}

TEST(Units, OfLengthsGoThereAndBack) {
  EXPECT_EQ(InMillimetres(0.012), 12);
  EXPECT_DOUBLE_EQ(InMillimetres(12 * kMillimetre), 12);
}

}  // namespace
}  // namespace moontrace
