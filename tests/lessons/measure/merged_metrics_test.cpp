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
  EXPECT_DOUBLE_EQ(all.mean_force, 0.3);
  EXPECT_DOUBLE_EQ(all.smoothness.log_jerk, 0.3);
  EXPECT_DOUBLE_EQ(all.duration, 40);
  EXPECT_DOUBLE_EQ(all.pause_time, 0.8);
  EXPECT_EQ(all.pauses, 5u);
  EXPECT_EQ(all.smoothness.peaks, 5);
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
