// How the hand went, beside how near it kept: side, sense, order, time, pauses, smoothness, shape.

#include <gtest/gtest.h>
#include <malloc.h>

#include <cmath>
#include <glm/vec2.hpp>
#include <random>
#include <vector>

#include "lessons/measure/scoring.h"
#include "tests/lessons/tracer.h"

namespace moontrace {
namespace {

TEST(Bias, IsTheOffsetWithItsSide) {
  for (const double d : {0.2e-3, -0.2e-3}) {
    Tracer tracer({Straight()});
    tracer.FollowLine({0, d}, {kLength, d});
    EXPECT_NEAR(tracer.Score().total.bias, d, 1e-15);  // the way is along x: y > 0 is left
  }
  Tracer weaving({Straight()});
  weaving.Follow([](double share) {
    return glm::dvec2(kLength * share, 0.2e-3 * std::sin(2 * kPi * 5 * share));
  });
  EXPECT_NEAR(weaving.Score().total.bias, 0, 1e-6);
  EXPECT_GT(weaving.Score().total.mean_error, 1e-4);
}

TEST(Bias, OfACircleOutsideARingIsOnTheRightOfACounterClockwiseWay) {
  const double ring = 5e-3, out = 0.2e-3;
  Tracer tracer({{StrokeKind::kStroke, {Arc{{0, 0}, ring, 0, 2 * kPi}}, kWidth, 0}});
  tracer.Follow([&](double share) {
    return (ring + out) * glm::dvec2(std::cos(2 * kPi * share), std::sin(2 * kPi * share));
  });
  EXPECT_NEAR(tracer.Score().total.bias, -out, 1e-12);
}

TEST(Direction, IsOneAlongMinusOneBackwardsAndBetweenForBoth) {
  Tracer along({Straight()}), back({Straight()}), both({Straight()});
  along.FollowLine({0, 0}, {kLength, 0});
  back.FollowLine({kLength, 0}, {0, 0});
  both.FollowLine({0, 0}, {kLength, 0});
  both.FollowLine({kLength, 0}, {0, 0});
  EXPECT_EQ(along.Score().total.direction, 1);
  EXPECT_EQ(back.Score().total.direction, -1);
  EXPECT_NEAR(both.Score().total.direction, 0, kWidth / kLength);  // told in steps of w/4
  EXPECT_EQ(Tracer({Straight()}).Score().total.direction, 0);
}

TEST(Direction, IsNotLostToTremor) {
  Tracer tracer({Straight()});
  tracer.Follow([](double share) {  // back and forth by 0.1 mm ten times while it goes
    return glm::dvec2(kLength * share + 1e-4 * std::sin(2 * kPi * 10 * share), 0);
  });
  EXPECT_EQ(tracer.Score().total.direction, 1);
}

TEST(Direction, KnowsTheSenseOfRings) {
  const IntendedStroke ring{StrokeKind::kStroke, {Arc{{0, 0}, 5e-3, 0, -2 * kPi}}, kWidth, 0};
  for (const double sense : {1.0, -1.0}) {
    Tracer tracer({ring});
    tracer.Follow([&](double share) {
      const double angle = -sense * 2 * kPi * share;
      return 5e-3 * glm::dvec2(std::cos(angle), std::sin(angle));
    });
    EXPECT_EQ(tracer.Score().total.direction, sense);
  }
}

std::vector<IntendedStroke> ThreeRungs() {
  std::vector<IntendedStroke> strokes;
  for (int i = 0; i < 3; ++i) {
    strokes.push_back({StrokeKind::kStroke, {Line{{0, 0.01 * i}, {kLength, 0.01 * i}}}, kWidth, 0});
  }
  return strokes;
}

double OrderOf(const std::vector<std::size_t>& visits) {
  Tracer tracer(ThreeRungs());
  for (const std::size_t stroke : visits) {
    tracer.stroke = stroke;
    const double y = 0.01 * static_cast<double>(stroke);
    tracer.FollowLine({0, y}, {kLength, y});
  }
  return tracer.Score().letters.at(0).order;
}

TEST(Order, IsKendallsTauOfFirstVisits) {
  EXPECT_EQ(OrderOf({0, 1, 2}), 1);
  EXPECT_EQ(OrderOf({2, 1, 0}), -1);
  EXPECT_NEAR(OrderOf({1, 0, 2}), 1.0 / 3, 1e-15);
  EXPECT_EQ(OrderOf({0, 1, 0, 2, 1}), 1);  // going back to a stroke is no other order
  EXPECT_EQ(OrderOf({2, 0}), -1);
  EXPECT_EQ(OrderOf({1}), 1);
}

TEST(Order, IsNotDecidedByATouchInPassing) {
  Tracer tracer(ThreeRungs());
  tracer.stroke = 2;
  tracer.FollowLine({0, 0.02}, {kWidth / 2, 0.02});
  for (const std::size_t stroke : {0U, 1U, 2U}) {
    tracer.stroke = stroke;
    const double y = 0.01 * static_cast<double>(stroke);
    tracer.FollowLine({0, y}, {kLength, y});
  }
  EXPECT_EQ(tracer.Score().total.order, 1);
}

TEST(Times, OfAScriptedTraceAreThoseOfTheScript) {
  Tracer tracer({Straight(kLength, 0), Straight(kLength, 1)}, 2);
  tracer.Follow([](double share) { return glm::dvec2(kLength / 2 * share, 0); });  // 1 s
  tracer.Follow([](double) { return glm::dvec2(kLength / 2, 0); });                // rests 1 s
  tracer.Follow([](double share) { return glm::dvec2(kLength / 2 * (1 + share), 0); });
  for (int i = 0; i < 1000; ++i) tracer.Touch({kLength, 0}, TracePhase::kStroke, false);
  const TraceScore score = tracer.Score();
  const TraceMetrics& letter = score.letters.at(0);
  EXPECT_NEAR(letter.duration, 4, 0.01);
  EXPECT_NEAR(letter.contact_share, 0.75, 0.01);
  EXPECT_NEAR(letter.mean_speed, kLength / 3, 0.01 * kLength);
  EXPECT_EQ(letter.pauses, 1u);
  EXPECT_NEAR(letter.pause_time, 1, 0.13);  // 0.6 mm at 10 mm/s on either side are in it
  EXPECT_NEAR(score.letters_per_second, 1 / score.total.duration, 1e-9);  // one of the two
  EXPECT_NEAR(SpeedAccuracyCost(letter), letter.duration * letter.mean_error, 1e-15);
}

TEST(Times, OutsideLastUntilTheReturn) {
  Tracer tracer({Straight()});
  tracer.Follow([](double share) {  // up to 0.8 w aside at half way and back
    return glm::dvec2(kLength * share, 0.8 * kWidth * (1 - std::abs(2 * share - 1)));
  });
  // Out at 0.5 w, in again at 0.25 w: shares 0.3125 and 0.84375 of 1 s.
  EXPECT_NEAR(tracer.Score().total.time_outside, 0.84375 - 0.3125, 0.003);
}

TEST(Forces, NormalOnesAreTheComponentAcrossThePage) {
  TraceScorer scorer({Straight()}, 1);
  TraceSample sample;
  sample.in_contact = true;
  sample.phase = TracePhase::kStroke;
  for (int i = 0; i < 10; ++i) {
    sample.time = 0.001 * i;
    sample.force_P = {0.3, 0, i == 5 ? 0.8 : 0.4};
    scorer.Add(sample);
  }
  const TraceMetrics total = scorer.Finish().total;
  EXPECT_NEAR(total.mean_normal_force, 0.44, 1e-12);
  EXPECT_DOUBLE_EQ(total.peak_normal_force, 0.8);
  EXPECT_NEAR(total.mean_force, (9 * 0.5 + std::hypot(0.3, 0.8)) / 10, 1e-12);
}

TEST(Conduct, SmoothnessIsThatOfTheMovements) {
  Tracer once({Straight()}), twice({Straight()});
  const auto eased = [](double s) { return s * s * s * (10 - 15 * s + 6 * s * s); };
  once.Follow([&](double s) { return glm::dvec2(kLength * eased(s), 0); });
  twice.Follow([&](double s) { return glm::dvec2(kLength / 2 * eased(s), 0); });
  twice.Follow([&](double s) { return glm::dvec2(kLength / 2 * (1 + eased(s)), 0); });
  const Smoothness one = once.Score().total.smoothness, two = twice.Score().total.smoothness;
  // What the stated filter takes from the golden values: movement_meter_test.cpp.
  EXPECT_NEAR(one.log_jerk, -5.3220, 0.18);
  EXPECT_NEAR(one.spectral_arc, -1.4024, 0.02);
  EXPECT_EQ(one.peaks, 1);
  EXPECT_EQ(two.peaks, 2);
  EXPECT_LT(two.log_jerk, one.log_jerk);
  EXPECT_LT(two.spectral_arc, one.spectral_arc);
}

TEST(Conduct, ShapeIsTheDistanceOfTheWayFromTheStroke) {
  Tracer on({Straight()}), aside({Straight()}), half({Straight()});
  const double d = 0.2e-3;
  on.FollowLine({0, 0}, {kLength, 0});
  aside.FollowLine({0, d}, {kLength, d});
  half.FollowLine({0, 0}, {kLength / 2, 0});
  // The way is kept as points, so its ends lie within a spacing (w/8) of the hand's.
  EXPECT_NEAR(on.Score().total.shape.warped, 0, 1e-9);
  EXPECT_NEAR(on.Score().total.shape.hausdorff, 0, 1e-9);
  EXPECT_NEAR(aside.Score().total.shape.warped, d, 1e-9);
  EXPECT_NEAR(aside.Score().total.shape.frechet, d, 1e-9);
  EXPECT_NEAR(half.Score().total.shape.frechet, kLength / 2, 1e-9);
  EXPECT_EQ(Tracer({Straight()}).Score().total.shape.warped, 0);
}

TEST(Conduct, LettersShapesAreJudgedOnLinesAndArcsAlike) {
  // A corner and a bend: the way itself, point by point.
  const std::vector<Piece> pieces{Line{{0, 0}, {0.01, 0}},
                                  Arc{{0.01, 0.005}, 0.005, -kPi / 2, kPi}};
  Tracer tracer({{StrokeKind::kStroke, pieces, kWidth, 0}});
  const double length = Length(pieces[0]) + Length(pieces[1]);
  tracer.Follow([&](double share) {
    const double s = share * length;
    return s < 0.01 ? PointAt(pieces[0], s) : PointAt(pieces[1], s - 0.01);
  });
  // Chords of w/8 on the arc are shorter than it by 1/6 (w/16/R)^2: a micron over all of it.
  EXPECT_NEAR(tracer.Score().total.shape.frechet, 0, 5e-6);
}

TEST(TraceScorer, SamplesOneByOneGiveWhatTheWholeGivesAtOnce) {
  // Asking in between changes nothing, and a copy of the samples scored afterwards is the same.
  std::vector<TraceSample> samples;
  std::mt19937_64 random(3);
  std::normal_distribution<double> shake(0, 5e-5);
  for (int i = 0; i < 3000; ++i) {
    TraceSample sample;
    sample.time = 0.001 * i;
    sample.tip_P = {kLength * i / 3000 + shake(random), shake(random), 0};
    sample.force_P = {0, 0, 1};
    sample.in_contact = i % 1000 > 20;
    sample.phase = TracePhase::kStroke;
    samples.push_back(sample);
  }
  TraceScorer asked({Straight()}, 1), whole({Straight()}, 1);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    asked.Add(samples[i]);
    if (i % 250 == 0) {
      EXPECT_NEAR(asked.Finish().total.coverage, asked.Coverage(), 1e-15);
    }
  }
  for (const TraceSample& sample : samples) whole.Add(sample);
  const TraceMetrics a = asked.Finish().total, b = whole.Finish().total;
  EXPECT_EQ(a.mean_error, b.mean_error);
  EXPECT_EQ(a.smoothness.log_jerk, b.smoothness.log_jerk);
  EXPECT_EQ(a.smoothness.spectral_arc, b.smoothness.spectral_arc);
  EXPECT_EQ(a.shape.warped, b.shape.warped);
  EXPECT_EQ(a.pauses, b.pauses);
  EXPECT_NE(a.smoothness.log_jerk, 0);
}

TEST(TraceScorer, HoldsNoMoreAfterHalfAnHourThanAfterAMinute) {
  TraceScorer scorer({Straight()}, 1);
  std::size_t held = 0;
  for (int i = 0; i <= 180000; ++i) {  // 100 samples a second, to and fro, resting, leaving
    TraceSample sample;
    sample.time = 0.01 * i;
    sample.tip_P = {kLength * (0.5 + 0.5 * std::sin(0.01 * i)), 8e-4 * std::sin(0.07 * i), 0};
    sample.in_contact = i % 700 > 30;
    sample.phase = TracePhase::kStroke;
    scorer.Add(sample);
    if (i == 6000) held = mallinfo2().uordblks;
  }
  EXPECT_LE(mallinfo2().uordblks, held + 4096);  // a page for what the test itself may hold
}

}  // namespace
}  // namespace moontrace
