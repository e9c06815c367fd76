#include "lessons/measure/nearest_stroke.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

IntendedStroke Upright(double x) {
  IntendedStroke stroke;
  stroke.spine_P = {Line{{x, 0.0}, {x, 0.01}}};
  stroke.width = 0.0014;
  return stroke;
}

TraceSample At(double x, double time, bool in_contact = true) {
  TraceSample sample;
  sample.time = time;
  sample.tip_P = {x, 0.005, 0};
  sample.in_contact = in_contact;
  return sample;
}

TEST(NearestStroke, IsFollowedAfterAnEntry) {
  NearestStroke nearest({Upright(0), Upright(0.01)}, 0.003);
  TraceSample sample = At(0.0095, 1.0);
  nearest.Assign(sample);
  EXPECT_EQ(sample.phase, TracePhase::kEntry);
  EXPECT_EQ(sample.stroke, 1U);
  sample = At(0.0095, 1.051);
  nearest.Assign(sample);
  EXPECT_EQ(sample.phase, TracePhase::kStroke);
}

TEST(NearestStroke, IsNoneInTheAirOrFarOff) {
  NearestStroke nearest({Upright(0), Upright(0.01)}, 0.003);
  TraceSample sample = At(0, 1.0, false);
  nearest.Assign(sample);
  EXPECT_EQ(sample.phase, TracePhase::kAir);
  sample = At(0.0051, 1.1);  // 4.9 mm from the nearer one
  nearest.Assign(sample);
  EXPECT_EQ(sample.phase, TracePhase::kAir);
}

TEST(NearestStroke, IsKeptUntilAnotherIsClearlyNearer) {
  NearestStroke nearest({Upright(0), Upright(0.002)}, 0.003);
  // 0.25 widths are 0.35 mm: kept up to 1.175 mm, where the distances differ by as much
  TraceSample sample = At(0.0005, 1.0);
  nearest.Assign(sample);
  sample = At(0.00115, 1.1);
  nearest.Assign(sample);
  EXPECT_EQ(sample.stroke, 0U);
  sample = At(0.0012, 1.2);
  nearest.Assign(sample);
  EXPECT_EQ(sample.stroke, 1U);
}

TEST(NearestStroke, IsNoneOnABlankPage) {
  NearestStroke nearest({}, 0.003);
  TraceSample sample = At(0, 1.0);
  nearest.Assign(sample);
  EXPECT_EQ(sample.phase, TracePhase::kAir);
}

}  // namespace
}  // namespace moontrace
