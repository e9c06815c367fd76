#include "sim/trial/trial.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/typeset.h"

#include <gtest/gtest.h>

#include <cmath>

namespace moontrace {
namespace {

TrialResult Page(double length, double coverage, double mean, double rms, double duration) {
  TrialResult page;
  page.stroke_length = length;
  page.duration = duration;
  page.real_time_factor = 100;
  page.score.total.coverage = coverage;
  page.score.total.mean_error = mean;
  page.score.total.rms_error = rms;
  page.score.total.duration = duration;
  page.score.total.mean_force = coverage;
  page.score.total.contact_share = coverage;
  page.score.total.excursions = 2;
  page.score.total.max_error = mean * 3;
  page.force_bound = length;
  return page;
}

TEST(Merged, WeighsErrorsByLengthAndForceByTimeInContact) {
  const TrialResult all = Merged({Page(1, 1.0, 1e-3, 2e-3, 10), Page(3, 0.5, 3e-3, 4e-3, 30)});
  const TraceMetrics& total = all.score.total;
  EXPECT_DOUBLE_EQ(total.coverage, 0.625);
  EXPECT_DOUBLE_EQ(total.mean_error, 2.5e-3);
  EXPECT_DOUBLE_EQ(total.rms_error, std::sqrt((4e-6 + 3 * 16e-6) / 4));
  EXPECT_DOUBLE_EQ(total.mean_force, 0.7);  // 10 s of 1 N, 15 s of 0.5 N
  EXPECT_DOUBLE_EQ(total.duration, 40);
  EXPECT_DOUBLE_EQ(total.max_error, 9e-3);
  EXPECT_EQ(total.excursions, 4U);
  EXPECT_DOUBLE_EQ(all.force_bound, 3);  // the greatest
  EXPECT_DOUBLE_EQ(all.real_time_factor, 100);
}

TEST(Merged, OfOnePageIsThatPage) {
  const TrialResult all = Merged({Page(2, 0.9, 1e-3, 2e-3, 10)});
  EXPECT_DOUBLE_EQ(all.score.total.coverage, 0.9);
  EXPECT_DOUBLE_EQ(all.score.total.rms_error, 2e-3);
}

TEST(BoundOfDirect, IsTheDesignsClosedForm) {
  const Script script = FindScript("moon");
  const TypeStyle style = DefaultStyle(0.006, Relief::kEngraved, script);
  const Typeset set = SetText("I", script, style, {"a5", 0.148, 0.210, 0.015});
  const TextureField field = PageField(set.pages.front(), script, set.style, false);
  const double slope = style.depth / (style.width / 2 - style.rounding);
  DeviceLimits limits;
  limits.damping = 3;
  limits.late_ticks = 1;
  const DirectBound bound = BoundOfDirect(field, Surface{}, 1.0, limits, 0.001);
  EXPECT_NEAR(bound.felt, 1000 * slope * slope + slope / style.rounding, 1e-6);
  EXPECT_NEAR(bound.held, 2000, 1e-9);  // 2 x 3 N s/m over three periods of 1 ms
  EXPECT_FALSE(bound.Holds());
  limits.late_ticks = 0;
  EXPECT_NEAR(BoundOfDirect(field, Surface{}, 1.0, limits, 0.001).held, 6000, 1e-9);
  EXPECT_TRUE(BoundOfDirect(TextureField(), Surface{}, 1.0, limits, 0.001).Holds());
}

}  // namespace
}  // namespace moontrace
