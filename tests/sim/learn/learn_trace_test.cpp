#include "sim/learn/learn_trace.h"

#include <gtest/gtest.h>

#include "tests/lessons/tracer.h"

namespace moontrace {
namespace {

constexpr double kTick = 1e-3;  // [s]

LearnTrace TraceOfALine() { return {{Straight()}, 1, kTick, 5e-3, false}; }

void Touch(LearnTrace& trace, glm::dvec2 p, int ticks, double begin = 0) {
  for (int i = 0; i < ticks; ++i) {
    LoopSample sample;
    sample.time = begin + kTick * i;
    sample.tip_P = {p, -1e-4};
    sample.in_contact = true;
    trace.Add(sample);
  }
}

TEST(LearnTrace, IsNotFollowedByATipThatRestsInTheGrooveOrCrossesIt) {
  LearnTrace trace = TraceOfALine();
  EXPECT_FALSE(trace.followed());
  Touch(trace, {kLength / 2, 0}, 2000);
  EXPECT_TRUE(trace.touched());
  // a quarter of the width to both sides of the tip: 3 percent of this line
  EXPECT_NEAR(trace.Coverage(), kWidth / 2 / kLength, 1e-3);
  EXPECT_FALSE(trace.followed());
}

TEST(LearnTrace, IsFollowedByATipThatGoesAlongTheGroove) {
  LearnTrace trace = TraceOfALine();
  for (int i = 0; i <= 500; ++i) Touch(trace, {i * kLength / 2000, 0}, 1, kTick * i);
  // the first 50 ms, 50 of 2000 parts, are entering; the radius counts at both ends
  EXPECT_NEAR(trace.Coverage(), 0.25 - 0.025 + 2 * kRadius / kLength, 1e-3);
  EXPECT_TRUE(trace.followed());
}

}  // namespace
}  // namespace moontrace
