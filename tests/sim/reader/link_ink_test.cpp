#include "sim/reader/link_ink.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

constexpr double kWidth = 0.001, kLink = 0.6;

HatchPoint Point(double x, double depth) {
  HatchPoint point;
  point.p = point.felt = {x, 0};
  point.ink = depth > 0.2;
  point.depth = depth;
  return point;
}

TEST(LinkInk, IsWhatIsNowhereAsDeepAsALetter) {
  // a letter's flank, its floor and its other flank; a link's, its floor, flat paper
  std::vector<HatchPoint> points = {Point(0, 0.5),      Point(0.0005, 1),     Point(0.001, 0.5),
                                    Point(0.0030, 0.3), Point(0.0033, kLink), Point(0.0036, 0.3),
                                    Point(0.0045, 0)};
  MarkLinks(points, kWidth, kLink);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].of_link, i >= 3 && i < 6) << i;
  }
}

// The tip was on one flank so far, and meets the floor when it comes back in the next column.
TEST(LinkInk, IsToldAnewWhenMoreWasFelt) {
  std::vector<HatchPoint> points = {Point(0, 0.5)};
  MarkLinks(points, kWidth, kLink);
  EXPECT_TRUE(points[0].of_link);
  points.push_back(Point(0.0004, 1));
  MarkLinks(points, kWidth, kLink);
  EXPECT_FALSE(points[0].of_link);
}

TEST(LinkInk, ThatIsAsDeepAsLettersCountsAsTheirs) {
  std::vector<HatchPoint> points = {Point(0, 0.9), Point(0.0003, 0.95)};
  MarkLinks(points, kWidth, kLink);
  EXPECT_FALSE(points[0].of_link || points[1].of_link);
}

}  // namespace
}  // namespace moontrace
