#include "sim/trial/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/mat3x3.hpp>

#include "sim/trial/speed_profile.h"

namespace moontrace {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kWidth = 1.4e-3;
constexpr double kSize = 0.012;

IntendedStroke OnPage(const std::vector<Piece>& em, glm::dvec2 origin_P, StrokeKind kind) {
  IntendedStroke stroke;
  stroke.kind = kind;
  stroke.width = kWidth;
  for (const Piece& piece : em) stroke.spine_P.push_back(Placed(piece, kSize, origin_P));
  return stroke;
}

IntendedStroke Roof() {  // A
  return OnPage({Line{{0, 0}, {0.5, 1}}, Line{{0.5, 1}, {1, 0}}}, {0.02, 0.1}, StrokeKind::kStroke);
}
IntendedStroke Ring() {  // O
  return OnPage({Arc{{0.5, 0.5}, 0.5, kPi / 2, 2 * kPi}}, {0.04, 0.1}, StrokeKind::kStroke);
}
IntendedStroke Zigzag() {  // N, whose corners are arcs of 0.125 em
  return OnPage({Line{{0, 0}, {0, 0.698}}, Arc{{0.125, 0.698}, 0.125, kPi, -0.75 * kPi},
                 Line{{0.213, 0.787}, {0.787, 0.213}},
                 Arc{{0.875, 0.302}, 0.125, 1.25 * kPi, 0.75 * kPi}, Line{{1, 0.302}, {1, 1}}},
                {0.06, 0.1}, StrokeKind::kStroke);
}
IntendedStroke Spot() {
  return OnPage({Line{{0.5, 0.5}, {0.5, 0.5}}}, {0.08, 0.1}, StrokeKind::kDot);
}
std::vector<IntendedStroke> AllStrokes() { return {Roof(), Ring(), Zigzag(), Spot()}; }

std::vector<HandPoint> PointsIn(const Plan& plan, const Plan::Span& span) {
  std::vector<HandPoint> points;
  for (const HandPoint& point : plan.path_W.points) {
    if (point.time >= span.begin - 1e-12 && point.time <= span.end + 1e-12) points.push_back(point);
  }
  return points;
}

const Plan::Span& SpanOf(const Plan& plan, TracePhase phase, std::size_t stroke) {
  for (const Plan::Span& span : plan.spans) {
    if (span.phase == phase && span.stroke == stroke) return span;
  }
  throw std::logic_error("no such span");
}

double DistanceToStroke(const IntendedStroke& stroke, glm::dvec3 p) {
  double nearest = 1e300;
  for (const Piece& piece : stroke.spine_P) {
    nearest = std::min(nearest, DistanceTo(piece, glm::dvec2(p)));
  }
  return nearest;
}

double SpeedBetween(const HandPoint& a, const HandPoint& b) {
  return glm::length(b.p_D - a.p_D) / (b.time - a.time);
}

TEST(OraclePlan, SpansFollowEachOtherWithoutGaps) {
  const Plan plan = MakeOraclePlan(AllStrokes(), PlanOptions{}, Pose{});
  ASSERT_EQ(plan.spans.size(), 16u);  // air, entry, stroke, lift for each of four
  EXPECT_EQ(plan.spans.front().begin, 0);
  EXPECT_EQ(plan.spans.back().end, plan.duration);
  EXPECT_EQ(plan.path_W.points.front().time, 0);
  EXPECT_EQ(plan.path_W.points.back().time, plan.duration);
  for (std::size_t i = 0; i < plan.spans.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(plan.spans[i].phase), i % 4);
    EXPECT_EQ(plan.spans[i].stroke, i / 4);
    EXPECT_GT(plan.spans[i].end, plan.spans[i].begin);
    if (i > 0) {
      EXPECT_EQ(plan.spans[i].begin, plan.spans[i - 1].end);
    }
  }
  for (std::size_t i = 1; i < plan.path_W.points.size(); ++i) {
    EXPECT_GT(plan.path_W.points[i].time, plan.path_W.points[i - 1].time);
  }
}

TEST(OraclePlan, StartsAndEndsWhereTheStrokesDo) {
  const auto strokes = AllStrokes();
  const Plan plan = MakeOraclePlan(strokes, PlanOptions{}, Pose{});
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const auto points = PointsIn(plan, SpanOf(plan, TracePhase::kStroke, i));
    const glm::dvec3 start(StartOf(strokes[i].spine_P.front()), 0);
    glm::dvec3 end(EndOf(strokes[i].spine_P.back()), 0);
    if (i == 1) {  // the ring: a quarter of the groove's width further, from its top to the left
      const double beyond = kPi / 2 + kWidth / 4 / (0.5 * kSize);
      end = {0.04 + kSize * (0.5 + 0.5 * std::cos(beyond)),
             0.1 + kSize * (0.5 + 0.5 * std::sin(beyond)), 0};
    }
    EXPECT_LT(glm::length(points.front().p_D - start), 1e-12) << i;
    EXPECT_LT(glm::length(points.back().p_D - end), 1e-12) << i;
  }
}

TEST(OraclePlan, StaysOnTheStrokeAlsoBetweenPoints) {
  const auto strokes = AllStrokes();
  const Plan plan = MakeOraclePlan(strokes, PlanOptions{}, Pose{});
  for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {  // the roof leans: see below
    const auto points = PointsIn(plan, SpanOf(plan, TracePhase::kStroke, i));
    double way = 0;
    for (std::size_t n = 1; n < points.size(); ++n) {
      EXPECT_LT(DistanceToStroke(strokes[i], points[n].p_D), 1e-5 * kWidth);
      // A chord c of a circle R is off by c^2 / 8R: 0.2 mm on 6 mm, 0.11 mm on 1.5 mm (21 mm/s).
      const glm::dvec3 middle = 0.5 * (points[n].p_D + points[n - 1].p_D);
      EXPECT_LT(DistanceToStroke(strokes[i], middle), 1.5e-6);
      way += glm::length(points[n].p_D - points[n - 1].p_D);
    }
    double length = i == 1 ? kWidth / 4 : 0;
    for (const Piece& piece : strokes[i].spine_P) length += Length(piece);
    EXPECT_NEAR(way, length, 1e-3 * length);  // nothing left out, nothing twice
  }
}

TEST(OraclePlan, KeepsItsSpeeds) {
  PlanOptions options;
  options.speed = 0.03;
  options.air_speed = 0.15;
  const Plan plan = MakeOraclePlan(AllStrokes(), options, Pose{});
  double fastest_stroke = 0, fastest_air = 0;
  for (const Plan::Span& span : plan.spans) {
    const auto points = PointsIn(plan, span);
    double& fastest = span.phase == TracePhase::kStroke ? fastest_stroke : fastest_air;
    for (std::size_t i = 1; i < points.size(); ++i) {
      fastest = std::max(fastest, SpeedBetween(points[i - 1], points[i]));
    }
  }
  EXPECT_LE(fastest_stroke, options.speed * (1 + 1e-9));
  EXPECT_GT(fastest_stroke, 0.99 * options.speed);
  EXPECT_LE(fastest_air, options.air_speed * (1 + 1e-9));
}

TEST(OraclePlan, TurnsCornersAtRestAndSlowsInCurves) {
  const auto strokes = AllStrokes();
  const Plan plan = MakeOraclePlan(strokes, PlanOptions{}, Pose{});
  const auto roof = PointsIn(plan, SpanOf(plan, TracePhase::kStroke, 0));
  const glm::dvec3 apex(EndOf(strokes[0].spine_P[0]), 0);
  bool turned = false;
  double fastest = 0;
  for (std::size_t i = 1; i < roof.size(); ++i) {
    if (!turned) {
      // At most 0.3 m/s^2, so at a distance d at most sqrt(0.6 d), and the step of 5 ms itself.
      const double from_apex = glm::length(roof[i].p_D - apex);
      EXPECT_LE(SpeedBetween(roof[i - 1], roof[i]), std::sqrt(0.6 * from_apex) + 0.3 * 0.005);
      turned = from_apex < 1e-12;
    }
    fastest = std::max(fastest, SpeedBetween(roof[i - 1], roof[i]));
  }
  EXPECT_TRUE(turned);
  EXPECT_GT(fastest, 0.03);
  const auto zigzag = PointsIn(plan, SpanOf(plan, TracePhase::kStroke, 2));
  const Arc& bend = std::get<Arc>(strokes[2].spine_P[1]);
  const glm::dvec3 middle(PointAt(bend, Length(bend) / 2), 0);
  double nearest = 1e300, speed = 0;
  for (std::size_t i = 1; i < zigzag.size(); ++i) {
    const double distance = glm::length(zigzag[i].p_D - middle);
    if (distance < nearest) {
      nearest = distance;
      speed = SpeedBetween(zigzag[i - 1], zigzag[i]);
    }
  }
  EXPECT_LE(speed, std::sqrt(0.3 * bend.radius) * (1 + 1e-9));
  EXPECT_GT(speed, 0.5 * std::sqrt(0.3 * bend.radius));
}

TEST(OraclePlan, LeansAwayFromTheLegItCameByAfterACorner) {
  const IntendedStroke roof = Roof();
  const Plan plan = MakeOraclePlan({roof}, PlanOptions{}, Pose{});
  const Line &up = std::get<Line>(roof.spine_P[0]), &down = std::get<Line>(roof.spine_P[1]);
  const glm::dvec2 along = TangentAt(down, 0), outwards(-along.y, along.x);
  const auto points = PointsIn(plan, SpanOf(plan, TracePhase::kStroke, 0));
  const double length = Length(Piece(up));
  bool turned = false;
  double greatest = 0;
  for (const HandPoint& point : points) {
    const glm::dvec2 p(point.p_D);
    turned = turned || glm::length(p - up.to) < 1e-12;
    if (!turned) {
      EXPECT_LT(DistanceTo(Piece(up), p), 1e-12);
      continue;
    }
    const double lean = glm::dot(p - down.from, outwards), way = glm::dot(p - down.from, along);
    greatest = std::max(greatest, lean);
    EXPECT_GE(lean, -1e-12);
    EXPECT_GE(way, -1e-12);
    if (way > 1.25 * kWidth / std::sin(2 * std::atan(0.5))) {
      EXPECT_NEAR(lean, 0, 1e-12);
    }
  }
  EXPECT_TRUE(turned);
  EXPECT_NEAR(greatest, 0.06 * length, 1e-9);
}

// Over its left half the ring's inner wall is missing, since a fill lies there: half a disc, whose
// chord runs through the ring's middle. The aim leans against the outer wall, by at most 0.4 w.
TEST(OraclePlan, LeansOutwardsWhereAFillTakesARingsInnerWallAway) {
  const IntendedStroke ring = Ring();
  const glm::dvec2 middle = std::get<Arc>(ring.spine_P[0]).center;
  const double radius = std::get<Arc>(ring.spine_P[0]).radius, lean = 0.4 * kWidth;
  IntendedStroke fill = OnPage({Line{{0.2, 0.8}, {0.2, 0.2}}}, {0.04, 0.1}, StrokeKind::kFill);
  for (const Piece& piece :
       std::vector<Piece>{Arc{{0.5, 0.5}, 0.55, kPi / 2, kPi}, Line{{0.5, -0.05}, {0.5, 1.05}}}) {
    fill.outline_P.push_back(Placed(piece, kSize, {0.04, 0.1}));
  }
  const Plan plan = MakeOraclePlan({fill, ring}, PlanOptions{}, Pose{});
  std::size_t left = 0, right = 0;
  for (const HandPoint& point : PointsIn(plan, SpanOf(plan, TracePhase::kStroke, 1))) {
    const glm::dvec2 p = glm::dvec2(point.p_D) - middle;
    if (std::abs(p.x) < kWidth) continue;  // where it goes from one to the other
    EXPECT_NEAR(glm::length(p), radius + (p.x < 0 ? lean : 0), 1e-9) << p.x << ' ' << p.y;
    ++(p.x < 0 ? left : right);
  }
  EXPECT_GT(left, 20u);
  EXPECT_GT(right, 20u);
}

TEST(OraclePlan, PressesOnTheSurfaceOnly) {
  PlanOptions options;
  options.press = 0.7;
  const Plan plan = MakeOraclePlan(AllStrokes(), options, Pose{});
  for (const HandPoint& point : plan.path_W.points) {
    if (point.press > 0) {
      EXPECT_EQ(point.p_D.z, 0);
    }
    EXPECT_GE(point.p_D.z, 0);
    EXPECT_LE(point.p_D.z, options.clearance * (1 + 1e-12));
  }
  for (const Plan::Span& span : plan.spans) {
    for (const HandPoint& point : PointsIn(plan, span)) {
      if (span.phase == TracePhase::kAir) {
        EXPECT_EQ(point.press, 0);
      }
      if (span.phase == TracePhase::kAir) {
        EXPECT_EQ(point.p_D.z, options.clearance);
      }
      if (span.phase == TracePhase::kStroke) {
        EXPECT_EQ(point.press, 0.7);
      }
    }
  }
}

TEST(OraclePlan, RestsOnADot) {
  PlanOptions options;
  options.dot_rest = 0.4;
  const Plan plan = MakeOraclePlan({Spot()}, options, Pose{});
  const Plan::Span& span = SpanOf(plan, TracePhase::kStroke, 0);
  EXPECT_NEAR(span.end - span.begin, 0.4, 1e-12);
  for (const HandPoint& point : PointsIn(plan, span)) {
    EXPECT_LT(glm::length(point.p_D - glm::dvec3(0.086, 0.106, 0)), 1e-12);
  }
}

TEST(OraclePlan, LiesWhereThePageLies) {
  const double tilt = 0.5;
  Pose X_WP;  // columns
  X_WP.R = glm::dmat3(glm::dvec3(1, 0, 0), glm::dvec3(0, std::cos(tilt), std::sin(tilt)),
                      glm::dvec3(0, -std::sin(tilt), std::cos(tilt)));
  X_WP.p = {0.1, -0.2, 0.3};
  const Plan level = MakeOraclePlan(AllStrokes(), PlanOptions{}, Pose{});
  const Plan tilted = MakeOraclePlan(AllStrokes(), PlanOptions{}, X_WP);
  ASSERT_EQ(level.path_W.points.size(), tilted.path_W.points.size());
  for (std::size_t i = 0; i < level.path_W.points.size(); ++i) {
    const HandPoint &a = level.path_W.points[i], &b = tilted.path_W.points[i];
    const glm::dvec3 expected(a.p_D.x + 0.1,
                              std::cos(tilt) * a.p_D.y - std::sin(tilt) * a.p_D.z - 0.2,
                              std::sin(tilt) * a.p_D.y + std::cos(tilt) * a.p_D.z + 0.3);
    ASSERT_LT(glm::length(b.p_D - expected), 1e-15);
    ASSERT_EQ(a.time, b.time);
    ASSERT_EQ(a.press, b.press);
  }
  const glm::dvec3 into = tilted.path_W.press_direction_D;
  EXPECT_LT(glm::length(into - glm::dvec3(0, std::sin(tilt), -std::cos(tilt))), 1e-15);
}

TEST(OraclePlan, WithoutStrokesRestsInTheAir) {
  const Plan plan = MakeOraclePlan({}, PlanOptions{}, Pose{});
  ASSERT_EQ(plan.spans.size(), 1u);
  EXPECT_EQ(plan.spans[0].phase, TracePhase::kAir);
  for (const HandPoint& point : plan.path_W.points) EXPECT_EQ(point.press, 0);
}

TEST(TimeRun, OfALongLineTakesTheTimeOfATrapezoid) {
  // Up to speed in v/a, the rest at v: L/v + v/a, and the 60 ms of averaging.
  const auto way = TimeRun({Line{{0, 0}, {0.1, 0}}}, 0.04, 0.005);
  EXPECT_EQ(way.front(), 0);
  EXPECT_NEAR(way.back(), 0.1, 1e-15);
  const double expected = 0.1 / 0.04 + 0.04 / 0.3 + 0.06;
  EXPECT_NEAR(static_cast<double>(way.size() - 1) * 0.005, expected, 0.0075);
  for (std::size_t i = 1; i < way.size(); ++i) EXPECT_GE(way[i], way[i - 1]);
}

TEST(TimeRun, ChangesAccelerationGently) {
  const double step = 0.001;
  const auto way = TimeRun({Line{{0, 0}, {0.02, 0}}}, 0.04, step);
  // 0.3 m/s^2 comes and goes within 60 ms, at the peak of a short run from plus to minus: 10 m/s^3;
  // nodes 0.05 mm apart and steps of 1 ms make it uneven by a few per cent at the ends.
  for (std::size_t i = 3; i < way.size(); ++i) {
    const double third = way[i] - 3 * way[i - 1] + 3 * way[i - 2] - way[i - 3];
    EXPECT_LT(std::abs(third) / (step * step * step), 1.2 * 0.6 / 0.06) << i;
  }
}

TEST(TimeRun, OfNoLengthStaysWhereItIs) {
  EXPECT_EQ(TimeRun({Line{{1, 1}, {1, 1}}}, 0.04, 0.005), std::vector<double>{0.0});
}

}  // namespace
}  // namespace moontrace
