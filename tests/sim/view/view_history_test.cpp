#include "sim/view/view_history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "sim/view/view_thread.h"
#include "tests/sim/view_fixture.h"

namespace moontrace {
namespace {

/// "l" begins with an upright line at its left, then goes right along the base line.
class ViewHistoryTest : public testing::Test {
 protected:
  ViewHistoryTest() : page_(PageOf("l")) {
    history_.Show(page_);
    const Piece& upright = page_->strokes.at(0).spine_P.at(0);
    middle_P_ = PointAt(upright, 0.5 * Length(upright));
  }
  ViewMoment At(double time, glm::dvec2 aside, bool in_contact = true) const {
    ViewMoment moment;
    moment.time = time;
    moment.page = 1;
    moment.present = true;
    moment.in_contact = in_contact;
    moment.tip_P = glm::dvec3(middle_P_ + aside, 0);
    return moment;
  }

  std::shared_ptr<const ViewPage> page_;
  ViewHistory history_;
  glm::dvec2 middle_P_{0, 0};
};

TEST_F(ViewHistoryTest, ErrorIsTheDistanceFromTheCentreLine) {
  history_.Add(At(0, {-0.0004, 0}));
  EXPECT_EQ(history_.stroke(), 0U);
  EXPECT_NEAR(history_.points().back().error, 0.4, 1e-9);  // [mm]
  ASSERT_EQ(history_.Path().size(), 1U);
  EXPECT_NEAR(history_.Path()[0].off, 0.0004 / (0.5 * page_->width), 1e-9);
}

TEST_F(ViewHistoryTest, WithoutContactThereIsNoErrorAndNoWay) {
  history_.Add(At(0, {0, 0}, false));
  EXPECT_LT(history_.points().back().error, 0);
  EXPECT_TRUE(history_.Path().empty());
  EXPECT_EQ(history_.stroke(), 0U);  // yet it is seen which stroke is below
}

TEST_F(ViewHistoryTest, FarFromEveryStrokeThereIsNone) {
  history_.Add(At(0, {-0.005, 0}));
  EXPECT_FALSE(history_.stroke());
  EXPECT_EQ(history_.Path().at(0).off, 1);
}

TEST_F(ViewHistoryTest, ALiftBreaksTheWay) {
  history_.Add(At(0, {0, 0}));
  history_.Add(At(0.01, {0, 0.0005}));
  history_.Add(At(0.02, {0, 0.001}, false));
  history_.Add(At(0.03, {0, 0.0015}));
  const auto path = history_.Path();
  ASSERT_EQ(path.size(), 3U);
  EXPECT_TRUE(path[0].begins);
  EXPECT_FALSE(path[1].begins);
  EXPECT_TRUE(path[2].begins);
}

TEST_F(ViewHistoryTest, PlottedIsTheGreatestOfEachBin) {
  for (int i = 0; i < 20; ++i) {
    ViewMoment moment = At(0.001 * i, {0, 0});
    moment.lateness_us = i == 7 ? 500 : 10;
    moment.force_P = {0, 0, i == 3 ? 2.0 : 1.0};
    moment.heat = 0.25;
    history_.Add(moment);
  }
  ASSERT_EQ(history_.points().size(), 1U);  // all within 20 ms
  EXPECT_EQ(history_.points()[0].lateness_us, 500);
  EXPECT_EQ(history_.points()[0].force, 2);
  EXPECT_EQ(history_.points()[0].heat, 25);
}

TEST_F(ViewHistoryTest, IsBounded) {
  for (int i = 0; i < 30000; ++i) {
    history_.Add(At(0.002 * i, {0.003 * std::sin(0.1 * i), 0.003 * std::cos(0.1 * i)}));
  }
  EXPECT_LE(history_.points().size(), 501U);  // 10 s of 20 ms
  EXPECT_GE(history_.points().size(), 450U);
  EXPECT_LE(history_.Path().size(), 1500U);
}

TEST_F(ViewHistoryTest, TimeThatGoesBackBeginsAnew) {
  history_.Add(At(5, {0, 0}));
  history_.Add(At(0, {0, 0.001}));
  EXPECT_EQ(history_.points().size(), 1U);
  EXPECT_EQ(history_.Path().size(), 1U);
}

TEST_F(ViewHistoryTest, ASnapshotBehindNewerSamplesForgetsNothing) {
  for (int i = 0; i < 1000; ++i) {
    history_.Add(At(0.002 * i, {0, 1e-4 * i}));
    if (i % 25 == 0) history_.Add(At(0.002 * i - 0.001, {0, 1e-4 * i}));
  }
  EXPECT_GE(history_.points().size(), 95U);  // 2 s of 20 ms
  EXPECT_GE(history_.Path().size(), 100U);
  EXPECT_DOUBLE_EQ(history_.newest()->time, 0.002 * 999);
}

TEST_F(ViewHistoryTest, AnotherPagesMomentLeavesNoWay) {
  ViewMoment other = At(0, {0, 0});
  other.page = 2;
  history_.Add(other);
  EXPECT_TRUE(history_.Path().empty());
  EXPECT_FALSE(history_.stroke());
}

TEST(TimeLog, KnowsMedianAndSlowest) {
  TimeLog log;
  EXPECT_EQ(log.Median(), 0);
  for (const double ms : {5.0, 1.0, 100.0, 2.0, 3.0}) log.Add(ms);
  EXPECT_EQ(log.Median(), 3);
  EXPECT_EQ(log.slowest(), 100);
  EXPECT_EQ(log.count(), 5U);
}

}  // namespace
}  // namespace moontrace
