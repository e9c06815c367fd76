#include "lessons/measure/merged_metrics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace moontrace {
namespace {

PageMetrics Page(double length, double duration, double value, std::size_t count) {
  PageMetrics page;
  page.stroke_length = length;
  TraceMetrics& m = page.total;
  m.duration = duration;
  m.coverage = m.mean_error = m.rms_error = m.max_error = m.bias = value;
  m.direction = m.order = m.shape.warped = m.shape.frechet = value;
  m.mean_force = m.contact_share = m.mean_speed = value;
  m.smoothness = {value, value, value, static_cast<double>(count)};
  m.excursions = m.pauses = count;
  m.time_outside = m.pause_time = value;
  return page;
}

TEST(MergedMetrics, WeighStrokesByLengthAndTimesByDuration) {
  const TraceMetrics all = MergedMetrics({Page(1, 30, 0.2, 2), Page(3, 10, 0.6, 3)});
  EXPECT_DOUBLE_EQ(all.coverage, 0.5);
  EXPECT_DOUBLE_EQ(all.bias, 0.5);
  EXPECT_DOUBLE_EQ(all.rms_error, std::sqrt((0.04 + 3 * 0.36) / 4));
  EXPECT_DOUBLE_EQ(all.direction, 0.5);
  EXPECT_DOUBLE_EQ(all.shape.warped, 0.5);
  EXPECT_DOUBLE_EQ(all.shape.frechet, 0.6);
  EXPECT_DOUBLE_EQ(all.smoothness.log_jerk, 0.3);
  EXPECT_DOUBLE_EQ(all.duration, 40);
  EXPECT_DOUBLE_EQ(all.pause_time, 0.8);
  EXPECT_EQ(all.pauses, 5u);
  EXPECT_EQ(all.smoothness.peaks, 5);
}

// A force is a mean over the time in contact: 6 s at 1 N and 2 s at 2 N.
TEST(MergedMetrics, WeighForcesByTheTimeInContact) {
  PageMetrics first = Page(1, 10, 1, 0), second = Page(1, 20, 2, 0);
  first.total.contact_share = 0.6;
  second.total.contact_share = 0.1;
  first.total.mean_normal_force = 1;
  second.total.mean_normal_force = 2;
  const TraceMetrics all = MergedMetrics({first, second});
  EXPECT_DOUBLE_EQ(all.mean_force, 1.25);
  EXPECT_DOUBLE_EQ(all.mean_normal_force, 1.25);
  EXPECT_DOUBLE_EQ(all.contact_share, 8.0 / 30);
}

TEST(MergedMetrics, APageWhereNothingWasFollowedHasNoErrorsButCountsAsNotCovered) {
  PageMetrics untouched;
  untouched.stroke_length = 1;
  untouched.total.duration = 10;
  const TraceMetrics all = MergedMetrics({untouched, Page(1, 10, 0.4, 0)});
  EXPECT_DOUBLE_EQ(all.coverage, 0.2);
  EXPECT_DOUBLE_EQ(all.mean_error, 0.4);
  EXPECT_DOUBLE_EQ(all.rms_error, 0.4);
  EXPECT_DOUBLE_EQ(all.bias, 0.4);
  EXPECT_DOUBLE_EQ(all.direction, 0.4);
  EXPECT_DOUBLE_EQ(all.shape.warped, 0.4);
  EXPECT_DOUBLE_EQ(all.mean_speed, 0.4);
}

TEST(MergedMetrics, PagesWithoutMovementsSayNothingOfSmoothness) {
  PageMetrics still = Page(1, 100, 0.5, 0);
  still.total.smoothness = {};
  EXPECT_DOUBLE_EQ(MergedMetrics({still, Page(1, 10, 0.3, 1)}).smoothness.log_jerk, 0.3);
}

TEST(MergedMetrics, OfNoPageIsAnEmptyTrace) {
  const TraceMetrics none = MergedMetrics({});
  EXPECT_EQ(none.coverage, 0);
  EXPECT_EQ(none.order, 1);
}

}  // namespace
}  // namespace moontrace
