#include "lessons/measure/scoring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <limits>
#include <stdexcept>

#include "tests/lessons/tracer.h"

namespace moontrace {
namespace {

TEST(TraceError, OfAnOffsetLineIsTheOffset) {
  Tracer tracer({Straight()});
  const double d = 0.2e-3;
  tracer.FollowLine({0, d}, {kLength, d});
  const TraceMetrics total = tracer.Score().total;
  EXPECT_NEAR(total.mean_error, d, 1e-15);
  EXPECT_NEAR(total.rms_error, d, 1e-15);
  EXPECT_NEAR(total.max_error, d, 1e-15);
  EXPECT_EQ(total.coverage, 1);
  EXPECT_EQ(total.excursions, 0u);
}

TEST(TraceError, GrowingEvenlyHasTheMeanAndRmsOfARamp) {
  Tracer tracer({Straight()});
  const double e = 0.5e-3;
  tracer.FollowLine({0, 0}, {kLength, e});
  const TraceMetrics total = tracer.Score().total;
  EXPECT_NEAR(total.mean_error, e / 2, 1e-15);
  EXPECT_NEAR(total.rms_error, e / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(total.max_error, e, 1e-15);
}

TEST(TraceError, IsNotChangedByPausing) {
  const auto way = [](double share) {
    return glm::dvec2(kLength * share, 0.25e-3 * std::sin(5 * share));
  };
  Tracer steady({Straight()}), pausing({Straight()});
  steady.Follow(way);
  for (int i = 0; i <= 1000; ++i) {
    const glm::dvec2 p = way(i / 1000.0);
    for (int pause = i == 300 ? 5000 : 1; pause > 0; --pause) pausing.Touch(p);
  }
  EXPECT_EQ(steady.Score().total.mean_error, pausing.Score().total.mean_error);
  EXPECT_EQ(steady.Score().total.rms_error, pausing.Score().total.rms_error);
  EXPECT_EQ(steady.Score().total.coverage, pausing.Score().total.coverage);
}

TEST(TraceError, OfACircleOutsideTheRingIsTheDifferenceOfRadii) {
  const double ring = 5e-3, out = 0.2e-3;
  Tracer tracer({{StrokeKind::kStroke, {Arc{{0, 0}, ring, 1, -2 * kPi}}, kWidth, 0}});
  tracer.Follow([&](double share) {
    return (ring + out) * glm::dvec2(std::cos(1 - 2 * kPi * share), std::sin(1 - 2 * kPi * share));
  });
  const TraceMetrics total = tracer.Score().total;
  EXPECT_NEAR(total.mean_error, out, 1e-15);
  EXPECT_NEAR(total.rms_error, out, 1e-15);
  EXPECT_NEAR(total.coverage, 1, 1e-12);
}

TEST(Coverage, OfHalfALineIsAHalfAndTheReachBeyond) {
  Tracer tracer({Straight()});
  tracer.FollowLine({0, 0}, {kLength / 2, 0});
  EXPECT_NEAR(tracer.Score().total.coverage, 0.5 + kRadius / kLength, 1e-12);
  tracer.FollowLine({kLength / 2, 0}, {0, 0});  // and back: the same
  EXPECT_NEAR(tracer.Score().total.coverage, 0.5 + kRadius / kLength, 1e-12);
}

TEST(Coverage, OfHalfARingReachesBeyondBothEnds) {
  const double ring = 5e-3, out = 0.1e-3, at = ring + out;
  Tracer tracer({{StrokeKind::kStroke, {Arc{{0, 0}, ring, 0, 2 * kPi}}, kWidth, 0}});
  tracer.Follow(
      [&](double share) { return at * glm::dvec2(std::cos(kPi * share), std::sin(kPi * share)); });
  // By the law of cosines.
  const double reach = std::acos((ring * ring + at * at - kRadius * kRadius) / (2 * ring * at));
  EXPECT_NEAR(tracer.Score().total.coverage, 0.5 + reach / kPi, 1e-12);
}

TEST(Coverage, IsZeroBeyondAQuarterOfTheWidth) {
  Tracer tracer({Straight()});
  tracer.FollowLine({0, 1.01 * kRadius}, {kLength, 1.01 * kRadius});
  EXPECT_EQ(tracer.Score().total.coverage, 0);
}

/// A flat floor 40 by 6 widths, its centre arc a line.
IntendedStroke Field() {
  const double high = 3 * kWidth, long_ = 40 * kWidth;
  IntendedStroke field{StrokeKind::kFill, {Line{{kWidth, 0}, {long_ - kWidth, 0}}}, kWidth, 0};
  field.outline_P = {Line{{0, -high}, {long_, -high}}, Line{{long_, -high}, {long_, high}},
                     Line{{long_, high}, {0, high}}, Line{{0, high}, {0, -high}}};
  return field;
}

// Nothing tells a hand where the middle of a wide floor is: all of it is the sign, up to its rim,
// of which as much is left out as of a groove's.
TEST(Coverage, OfAFillIsThatOfTheFloorAlongItsCentreArc) {
  for (const double aside : {0.0, 1.0, -2.2, 2.74, -2.76, 3.1}) {
    Tracer tracer({Field()});
    tracer.FollowLine({kWidth, aside * kWidth}, {39 * kWidth, aside * kWidth});
    const TraceMetrics total = tracer.Score().total;
    EXPECT_NEAR(total.coverage, std::abs(aside) < 2.75 ? 1 : 0, 1e-12) << aside;
    EXPECT_NEAR(total.mean_error, kWidth * std::max(std::abs(aside) - 2.5, 0.0), 1e-12) << aside;
    EXPECT_EQ(total.excursions, std::abs(aside) > 3 ? 1u : 0u) << aside;
    EXPECT_NEAR(std::abs(total.bias), total.mean_error, 1e-12) << aside;
  }
}

TEST(Coverage, OfAFillIsOnlyOfWhatLiesBesideTheTip) {
  Tracer tracer({Field()});
  tracer.FollowLine({kWidth / 2, 2 * kWidth}, {20 * kWidth, 2 * kWidth});  // from before its end on
  EXPECT_NEAR(tracer.Score().total.coverage, (19 + 0.25) / 38, 1e-12);
  Tracer beyond({Field()});
  beyond.FollowLine({0.6 * kWidth, -2 * kWidth}, {0.6 * kWidth, 2 * kWidth});
  EXPECT_EQ(beyond.Score().total.coverage, 0);
}

TEST(Coverage, OfALetterIsWeighedByLengthADotCountingOneWidth) {
  std::vector<IntendedStroke> strokes = {Straight(3 * kWidth, 0), Straight(kLength, 1)};
  strokes.push_back({StrokeKind::kDot, {Line{{0, 0.01}, {0, 0.01}}}, kWidth, 0});
  Tracer tracer(strokes, 2);
  tracer.FollowLine({0, 0}, {3 * kWidth, 0});
  EXPECT_NEAR(tracer.Score().letters.at(0).coverage, 0.75, 1e-12);
  EXPECT_EQ(tracer.Score().letters.at(1).coverage, 0);
  EXPECT_NEAR(tracer.Score().total.coverage, 3 * kWidth / (4 * kWidth + kLength), 1e-12);
  tracer.stroke = 2;
  tracer.Touch({0, 0.01});
  EXPECT_NEAR(tracer.Score().letters.at(0).coverage, 1, 1e-12);
}

TEST(Dot, IsCoveredWhenTouchedWithinAQuarterWidth) {
  const IntendedStroke dot{StrokeKind::kDot, {Line{{1e-3, 0}, {1e-3, 0}}}, kWidth, 0};
  Tracer near({dot}), far({dot});
  near.Touch({1e-3, 0.9e-3});
  near.Touch({1e-3, 0.99 * kRadius});
  near.Touch({1e-3, 0.9e-3});
  far.Touch({1e-3, 1.01 * kRadius});
  EXPECT_EQ(near.Score().total.coverage, 1);
  EXPECT_NEAR(near.Score().total.mean_error, 0.99 * kRadius, 1e-15);  // the closest approach
  EXPECT_NEAR(near.Score().total.max_error, 0.99 * kRadius, 1e-15);
  EXPECT_EQ(near.Score().total.excursions, 0u);
  EXPECT_EQ(far.Score().total.coverage, 0);
  EXPECT_NEAR(far.Score().total.mean_error, 1.01 * kRadius, 1e-15);
}

TEST(Dot, WeighsOneWidthInTheErrorOfALetter) {
  std::vector<IntendedStroke> strokes = {Straight()};
  strokes.push_back({StrokeKind::kDot, {Line{{0, 0.01}, {0, 0.01}}}, kWidth, 0});
  Tracer tracer(strokes);
  tracer.FollowLine({0, 0.1e-3}, {kLength, 0.1e-3});
  tracer.stroke = 1;
  tracer.Touch({0.2e-3, 0.01});
  EXPECT_NEAR(tracer.Score().total.mean_error,
              (kLength * 0.1e-3 + kWidth * 0.2e-3) / (kLength + kWidth), 1e-15);
}

TEST(Excursions, CountEveryCrossingOfAScriptedSine) {
  for (const int crossings : {1, 4, 9}) {
    Tracer tracer({Straight()});
    tracer.Follow([&](double share) {
      return glm::dvec2(kLength * share, 0.7 * kWidth * std::sin(kPi * crossings * share));
    });
    const TraceScore score = tracer.Score();
    EXPECT_EQ(score.total.excursions, static_cast<std::size_t>(crossings));
    ASSERT_EQ(score.left_at.size(), static_cast<std::size_t>(crossings));
    // It leaves where the sine reaches 0.5 / 0.7; a step is kLength / 1000.
    EXPECT_NEAR(score.left_at[0].p_P.x, kLength * std::asin(0.5 / 0.7) / kPi / crossings,
                kLength / 1000);
  }
}

TEST(Excursions, AreNotCountedAgainBeforeTheReturn) {
  Tracer tracer({Straight()});
  tracer.Follow([&](double share) {  // between 0.3 w and 0.7 w: leaves, never comes back
    return glm::dvec2(kLength * share, kWidth * (0.5 + 0.2 * std::sin(40 * share)));
  });
  EXPECT_EQ(tracer.Score().total.excursions, 1u);
}

TEST(TraceScorer, KeepsEntriesAndLiftsApart) {
  Tracer tracer({Straight()});
  for (int i = 0; i < 10; ++i) tracer.Touch({0, 3e-3}, TracePhase::kAir, false);
  tracer.Touch({0, 0.4e-3}, TracePhase::kEntry, false);
  tracer.Touch({0, 0.3e-3}, TracePhase::kEntry);       // lands 0.3 mm off
  tracer.Touch({0, 2e-3}, TracePhase::kEntry, false);  // bounces
  tracer.Touch({0, 0.1e-3}, TracePhase::kEntry);
  tracer.FollowLine({0, 0}, {kLength / 2, 0});
  tracer.Touch({kLength / 2, 0}, TracePhase::kStroke, false);
  tracer.FollowLine({kLength / 2, 0}, {kLength, 0});
  tracer.FollowLine({kLength, 0}, {kLength, 0});
  tracer.Touch({kLength, 5e-3}, TracePhase::kLift);
  const TraceMetrics total = tracer.Score().total;
  EXPECT_EQ(total.entries, 1u);
  EXPECT_NEAR(total.entry_error, 0.3e-3, 1e-15);
  EXPECT_EQ(total.lifts, 1u);
  EXPECT_EQ(total.max_error, 0);
  EXPECT_EQ(total.excursions, 0u);
}

TEST(TraceScorer, CountsOnlyContact) {
  Tracer tracer({Straight()});
  for (int i = 0; i <= 100; ++i) tracer.Touch({kLength * i / 100, 0}, TracePhase::kStroke, false);
  EXPECT_EQ(tracer.Score().total.coverage, 0);
  EXPECT_EQ(tracer.Score().total.entries, 0u);
  EXPECT_EQ(tracer.Score().total.mean_force, 0);
}

TEST(TraceScorer, TellsTimesAndForces) {
  Tracer tracer({Straight(kLength, 0), Straight(kLength, 1)}, 2);
  tracer.Touch({0, 0}, TracePhase::kAir, false);
  for (int i = 0; i < 100; ++i) tracer.Touch({0, 0}, TracePhase::kStroke, true, 1.0);
  for (int i = 0; i < 50; ++i) tracer.Touch({0, 0}, TracePhase::kAir, false);
  tracer.stroke = 1;
  for (int i = 0; i < 300; ++i) tracer.Touch({0, 0}, TracePhase::kEntry, true, 2.0);
  const TraceScore score = tracer.Score();
  EXPECT_NEAR(score.letters.at(0).duration, 0.100, 1e-12);
  EXPECT_NEAR(score.letters.at(1).duration, 0.300, 1e-12);
  EXPECT_NEAR(score.total.duration, 0.450, 1e-12);
  EXPECT_NEAR(score.letters.at(0).mean_force, 1, 1e-12);
  EXPECT_NEAR(score.total.mean_force, 700.0 / 400, 1e-12);
  EXPECT_EQ(score.total.peak_force, 2);
}

// A hand that is flung through the air feels that.
TEST(TraceScorer, TellsThePeakOfAllForcesAndTheMeanOfTouch) {
  Tracer tracer({Straight()});
  for (int i = 0; i < 100; ++i) tracer.Touch({0, 0}, TracePhase::kStroke, true, 1.0);
  tracer.Touch({0, 0}, TracePhase::kAir, false, 30.0);
  EXPECT_EQ(tracer.Score().total.peak_force, 30);
  EXPECT_NEAR(tracer.Score().total.mean_force, 1, 1e-12);
}

TEST(TraceScorer, LeavesOutTipsThatAreNotFinite) {
  Tracer tracer({Straight()});
  tracer.FollowLine({0, 0.1e-3}, {kLength, 0.1e-3});
  tracer.Touch({std::numeric_limits<double>::quiet_NaN(), 0});
  const TraceMetrics total = tracer.Score().total;
  EXPECT_NEAR(total.mean_error, 0.1e-3, 1e-15);
  EXPECT_EQ(total.coverage, 1);
}

TEST(TraceScorer, RefusesStrokesAndGlyphsThatAreNotThere) {
  EXPECT_THROW(TraceScorer({Straight(kLength, 3)}, 3), std::invalid_argument);
  Tracer tracer({Straight()});
  tracer.stroke = 1;
  EXPECT_THROW(tracer.Touch({0, 0}), std::out_of_range);
}

}  // namespace
}  // namespace moontrace
