// Where the push leads to: memory of the arc length, continuity, strokes in writing order.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <random>

#include "lessons/guide/guidance.h"
#include "tests/lessons/guidance_fixture.h"

namespace moontrace {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr GuidanceMode kPushing[] = {GuidanceMode::kAttract, GuidanceMode::kRail,
                                     GuidanceMode::kBead, GuidanceMode::kAmplify};

IntendedStroke Ring() { return GuideStroke({Arc{{0.01, 0.01}, 0.006, 0, 2 * kPi}}); }
/// Two legs 3 mm apart at their ends, that meet at an acute angle.
IntendedStroke Hairpin() {
  return GuideStroke({Line{{0, 0}, {0.02, 0.0015}}, Line{{0.02, 0.0015}, {0, 0.003}}});
}
/// A line that crosses itself: down through a loop and out again over its own beginning.
IntendedStroke Loop() {
  return GuideStroke({Line{{0, 0}, {0.02, 0}}, Arc{{0.02, 0.005}, 0.005, -kPi / 2, 3 * kPi / 2},
                      Line{{0.015, 0.005}, {0.015, -0.015}}});
}

/// At every tick force may change by no more than the stiffness times the ways of tip and target,
/// and the ramp. `walk` gives the tip of each tick.
template <class Walk>
void ExpectContinuous(const GuidancePlan& plan, int ticks, const Walk& walk) {
  GuidanceState state;
  glm::dvec2 last_p = walk(0);
  glm::dvec3 last = HoldTip(plan, state, last_p, 1).force_P;
  for (int i = 1; i < ticks; ++i) {
    const glm::dvec2 p = walk(i);
    const glm::dvec3 force = HoldTip(plan, state, p, 1).force_P;
    const double moved = glm::distance(p, last_p);
    // ramp: steepest 1.5 / 0.3 s; amplify's fading at the box: the cap over half a width
    const double by_ramp = plan.gains.cap * 1.5 * kGuideTick / 0.3;
    const double by_box = plan.mode == GuidanceMode::kAmplify ? plan.gains.cap / 0.0007 * moved : 0;
    EXPECT_LE(glm::length(force - last),
              plan.gains.stiffness * (3 * moved + kSlidePerTick) + by_ramp + by_box + 1e-9)
        << "tick " << i;
    last = force;
    last_p = p;
  }
}

TEST(GuidanceMemory, AtACrossingTheTargetStaysOnItsStroke) {
  const IntendedStroke rising = GuideStroke({Line{{0, 0}, {0.01, 0.01}}});
  const IntendedStroke falling = GuideStroke({Line{{0, 0.01}, {0.01, 0}}});
  GuidancePlan plan = GuidePlan(GuidanceMode::kAttract, {rising, falling});
  GuidanceState state;
  HoldTip(plan, state, {0, 0}, 400);
  // The tip wanders 0.6 mm to the side, so that the other stroke is nearer near the crossing.
  for (int i = 0; i <= 800; ++i) {
    const double along = 1e-5 * i;
    const glm::dvec2 p = glm::dvec2(along, along) + 0.0006 * glm::dvec2(-1, 1) / std::sqrt(2.0);
    const GuidanceResult result = HoldTip(plan, state, p, 1);
    ASSERT_NEAR(result.target_P.x, result.target_P.y, 1e-12) << "tick " << i;
    ASSERT_EQ(state.stroke, 0U);
  }
}

TEST(GuidanceMemory, WhereAStrokeCrossesItselfTheTargetGoesOnAlongIt) {
  const GuidancePlan plan = GuidePlan(GuidanceMode::kRail, {Loop()});
  const GuidanceStroke& stroke = plan.path->strokes[0];
  GuidanceState state;
  HoldTip(plan, state, {0, 0}, 400);
  double last = 0;
  for (double s = 0; s < stroke.length; s += 3e-5) {
    const glm::dvec2 along = TangentAt(stroke, s);
    const glm::dvec2 p = PointAt(stroke, s) + 0.0004 * glm::dvec2(-along.y, along.x);
    HoldTip(plan, state, p, 1);
    ASSERT_GE(state.s, last - 1e-9);
    ASSERT_NEAR(state.s, s, 0.002);
    last = state.s;
  }
  EXPECT_NEAR(last, stroke.length, 0.001);
}

TEST(GuidanceMemory, InTheMiddleOfARingNothingSprings) {
  for (const GuidanceMode mode : kPushing) {
    // in at the start, across the centre at 100 mm/s, and back a little beside it
    ExpectContinuous(GuidePlan(mode, {Ring()}), 1200, [](int i) {
      if (i < 400) return glm::dvec2(0.016, 0.01);
      if (i < 520) return glm::dvec2(0.016 - 1e-4 * (i - 400), 0.01);
      if (i < 700) return glm::dvec2(0.004, 0.01);
      return glm::dvec2(0.004 + 1e-4 * std::min(i - 700, 120), 0.0101);
    });
  }
}

TEST(GuidanceMemory, AcrossARingTheTargetComesRoundToTheNearSide) {
  const GuidancePlan plan = GuidePlan(GuidanceMode::kAttract, {Ring()});
  GuidanceState state;
  HoldTip(plan, state, {0.016, 0.01}, 400);
  MoveTip(plan, state, {0.016, 0.01}, {0.006, 0.0101}, 200);
  const GuidanceResult result = HoldTip(plan, state, {0.006, 0.0101}, 500);
  EXPECT_LT(result.target_P.x, 0.0045);
}

TEST(GuidanceMemory, InsideAHairpinNothingSprings) {
  for (const GuidanceMode mode : kPushing) {
    ExpectContinuous(GuidePlan(mode, {Hairpin()}), 2000, [](int i) {
      const double x = i < 400 ? 0 : std::min(0.0199, 2e-5 * (i - 400));
      const double y = i < 400 ? 0 : 0.0015 + 0.0012 * std::sin(0.05 * i);
      return i < 500 ? glm::dvec2(x, y * std::max(0, i - 400) / 100.0) : glm::dvec2(x, y);
    });
  }
}

TEST(GuidanceMemory, ForceIsContinuousAlongAnyContinuousWay) {
  std::mt19937 random(11);
  std::normal_distribution<double> push(0, 1);
  for (const GuidanceMode mode : kPushing) {
    GuidancePlan plan = GuidePlan(mode, {Ring(), Hairpin(), Loop()});
    plan.gains.dead_zone_widths = mode == GuidanceMode::kAttract ? 0.3 : 0;
    // A hand that is thrown about and held to the page by a spring.
    std::vector<glm::dvec2> way{{0.016, 0.01}};
    glm::dvec2 v{0, 0};
    for (int i = 0; i < 20000; ++i) {
      const glm::dvec2 home = i % 2000 < 1000 ? glm::dvec2(0.02, 0.002) : glm::dvec2(0.004, 0.01);
      v += 0.004 * glm::dvec2(push(random), push(random)) + 0.05 * (home - way.back()) - 0.01 * v;
      way.push_back(way.back() + kGuideTick * v);
    }
    ExpectContinuous(plan, static_cast<int>(way.size()),
                     [&way](int i) { return way[static_cast<std::size_t>(i)]; });
  }
}

TEST(GuidanceOrder, OneStrokeAfterTheOtherWithTheLeadThroughTheAirBetween) {
  const IntendedStroke first = GuideStroke({Line{{0, 0}, {0.01, 0}}});
  const IntendedStroke second = GuideStroke({Line{{0, 0.01}, {0.01, 0.01}}});
  const GuidancePlan plan = GuidePlan(GuidanceMode::kAttract, {first, second});
  GuidanceState state;
  HoldTip(plan, state, {0, 0}, 400);
  MoveTip(plan, state, {0, 0}, {0.01, 0}, 300);
  EXPECT_EQ(state.stroke, 0U);
  GuidanceResult result = Guide(plan, state, {0.01, 0, 0.003}, {0, 0, 0}, kGuideTick);  // lifted
  EXPECT_EQ(state.stroke, 1U);
  EXPECT_TRUE(state.in_transit);
  EXPECT_LT(glm::length(result.force_P), 0.01);  // nothing springs
  // a hand that stays is drawn towards the next start, as far as the leash
  for (int i = 0; i < 1000; ++i) {
    result = Guide(plan, state, {0.01, 0, 0.003}, {0, 0, 0}, kGuideTick);
  }
  EXPECT_NEAR(glm::distance(result.target_P, {0.01, 0}), 2 * kGuideWidth, 3e-5);
  EXPECT_LT(result.force_P.x, -0.2);
  EXPECT_GT(result.force_P.y, 0.2);
  // and there the second stroke is taken up
  MoveTip(plan, state, {0.01, 0}, {0, 0.01}, 1000);
  HoldTip(plan, state, {0, 0.01}, 100);
  EXPECT_FALSE(state.in_transit);
  EXPECT_TRUE(state.captured);
  MoveTip(plan, state, {0, 0.01}, {0.01, 0.01}, 300);
  HoldTip(plan, state, {0.01, 0.012}, 160);
  EXPECT_TRUE(state.done);
  EXPECT_EQ(HoldTip(plan, state, {0.01, 0.02}, 301).force_P, glm::dvec3(0));  // faded out
}

TEST(GuidanceOrder, AStrokeDoesNotCountAsFollowedFromAfar) {
  const GuidancePlan plan =
      GuidePlan(GuidanceMode::kRail, {GuideStroke({Line{{0, 0}, {0.02, 0}}})});
  GuidanceState state;
  const GuidanceResult result = HoldTip(plan, state, {0.02, 0.003}, 3000);
  EXPECT_FALSE(state.done);
  EXPECT_EQ(result.target_P, glm::dvec2(0, 0));  // still to its start
}

TEST(GuidanceOrder, DotsAreTakenOneByOne) {
  const auto dot = [](double x) { return GuideStroke({Line{{x, 0}, {x, 0}}}); };
  for (const GuidanceMode mode : {GuidanceMode::kAttract, GuidanceMode::kBead}) {
    const GuidancePlan plan = GuidePlan(mode, {dot(0), dot(0.01)});
    GuidanceState state;
    PassiveHand hand;
    hand.p = {-0.001, 0.001};
    for (int i = 0; i < 3000 && !state.done; ++i) {
      hand.Push(Guide(plan, state, {hand.p, 0}, {hand.v, 0}, kGuideTick).force_P);
    }
    EXPECT_TRUE(state.done);
    EXPECT_LT(glm::distance(hand.p, {0.01, 0}), kGuideWidth);
  }
}

TEST(GuidanceOrder, AmplifyTakesUpTheStrokeWhereTheTipLands) {
  const GuidancePlan plan = GuidePlan(
      GuidanceMode::kAmplify,
      {GuideStroke({Line{{0, 0}, {0.02, 0}}}), GuideStroke({Line{{0, 0.01}, {0.02, 0.01}}})});
  GuidanceState state;
  EXPECT_EQ(HoldTip(plan, state, {0.01, 0.005}, 400).force_P, glm::dvec3(0));
  HoldTip(plan, state, {0.01, 0.011}, 400);
  EXPECT_EQ(state.stroke, 1U);
  EXPECT_NEAR(HoldTip(plan, state, {0.01, 0.0105}, 400).force_P.y, 200 * 0.0005, 1e-9);
}

}  // namespace
}  // namespace moontrace
