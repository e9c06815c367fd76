#include "textures/fonts/svg_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <string>
#include <vector>

namespace moontrace {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<Subpath> Parse(const std::string& path) {
  PathLimits limits;
  return ParseSvgPath(path, limits);
}

/// Corners of a path of lines: every piece's start and the last end.
std::vector<glm::dvec2> CornersOf(const Subpath& subpath) {
  std::vector<glm::dvec2> corners;
  for (const Piece& piece : subpath.pieces) corners.push_back(std::get<Line>(piece).from);
  corners.push_back(std::get<Line>(subpath.pieces.back()).to);
  return corners;
}

using Points = std::vector<glm::dvec2>;

TEST(ParseSvgPath, ReadsLinesAbsoluteAndRelativeAlike) {
  const Points square = {{10, 20}, {30, 20}, {30, 50}, {10, 50}};
  for (const char* path :
       {"M10 20 L30 20 L30 50 L10 50", "M10 20 30 20 30 50 10 50", "m10,20 20,0 0,30-20 0",
        "M10 20H30V50H10", "M 10 20 h20v30h-20", "\n M1e1,2.E+1l200e-1 0\t0 +30\r-20 0 "}) {
    const std::vector<Subpath> subpaths = Parse(path);
    ASSERT_EQ(subpaths.size(), 1U) << path;
    EXPECT_EQ(CornersOf(subpaths[0]), square) << path;
    EXPECT_FALSE(subpaths[0].closed) << path;
  }
}

TEST(ParseSvgPath, ReadsNumbersWithoutSeparators) {
  EXPECT_EQ(CornersOf(Parse("M.5.5-1-.25L1.5.75")[0]),
            (Points{{0.5, 0.5}, {-1, -0.25}, {1.5, 0.75}}));
}

TEST(ParseSvgPath, ClosesWithALineAndGoesOnFromTheStart) {
  const std::vector<Subpath> subpaths = Parse("M0 0L10 0L10 10ZL-5 5");
  ASSERT_EQ(subpaths.size(), 2U);
  EXPECT_TRUE(subpaths[0].closed);
  EXPECT_EQ(CornersOf(subpaths[0]), (Points{{0, 0}, {10, 0}, {10, 10}, {0, 0}}));
  EXPECT_FALSE(subpaths[1].closed);
  EXPECT_EQ(CornersOf(subpaths[1]), (Points{{0, 0}, {-5, 5}}));
}

TEST(ParseSvgPath, TakesARelativeMoveAfterZFromTheStart) {
  const std::vector<Subpath> subpaths = Parse("m5 5 l10 0 l0 10 z m1 1 l1 0");
  ASSERT_EQ(subpaths.size(), 2U);
  EXPECT_EQ(CornersOf(subpaths[1]), (Points{{6, 6}, {7, 6}}));
}

TEST(ParseSvgPath, DropsPiecesWithoutLength) {
  const std::vector<Subpath> subpaths = Parse("M0 0L0 0L10 0L10 0M5 5M6 6ZM7 7L8 8");
  ASSERT_EQ(subpaths.size(), 2U);
  EXPECT_EQ(CornersOf(subpaths[0]), (Points{{0, 0}, {10, 0}}));
  EXPECT_EQ(CornersOf(subpaths[1]), (Points{{7, 7}, {8, 8}}));
  EXPECT_TRUE(Parse("").empty());
  EXPECT_TRUE(Parse("M3 3").empty());
  EXPECT_TRUE(Parse("M3 3a1 1 0 0 1 0 0c0 0 0 0 0 0").empty());
}

TEST(ParseSvgPath, KeepsCircularArcsExactly) {
  // The four arcs of radius 5 from (5,0) to (0,5): flags choose the circle and the way round.
  struct Case {
    const char* path;
    glm::dvec2 center;
    double sweep;
  };
  for (const Case& c : {Case{"M5 0A5 5 0 0 1 0 5", {0, 0}, kPi / 2},
                        Case{"M5 0A5 5 0 1 0 0 5", {0, 0}, -3 * kPi / 2},
                        Case{"M5 0A5 5 0 0 0 0 5", {5, 5}, -kPi / 2},
                        Case{"M5 0A5 5 30 1 1 0 5", {5, 5}, 3 * kPi / 2},
                        Case{"M5 0a5 5 0 01-5 5", {0, 0}, kPi / 2},
                        Case{"M5 0a-5-5 0 1,0-5,5", {0, 0}, -3 * kPi / 2}}) {
    const std::vector<Subpath> subpaths = Parse(c.path);
    ASSERT_EQ(subpaths.size(), 1U) << c.path;
    ASSERT_EQ(subpaths[0].pieces.size(), 1U) << c.path;
    const Arc& arc = std::get<Arc>(subpaths[0].pieces[0]);
    EXPECT_LT(glm::length(arc.center - c.center), 1e-12) << c.path;
    EXPECT_NEAR(arc.radius, 5, 1e-12) << c.path;
    EXPECT_NEAR(arc.sweep, c.sweep, 1e-12) << c.path;
    EXPECT_LT(glm::length(StartOf(arc) - glm::dvec2(5, 0)), 1e-12) << c.path;
  }
}

TEST(ParseSvgPath, ReadsArcFlagsWithoutSeparators) {
  const std::vector<Subpath> packed = Parse("M0 0a1 1 0 01.5.5");
  const std::vector<Subpath> spaced = Parse("M0 0a1 1 0 0 1 0.5 0.5");
  ASSERT_EQ(packed.size(), 1U);
  EXPECT_EQ(packed[0].pieces, spaced[0].pieces);
  EXPECT_LT(glm::length(EndOf(packed[0].pieces[0]) - glm::dvec2(0.5, 0.5)), 1e-12);
}

TEST(ParseSvgPath, MakesALineOfAnArcWithoutRadiusAndGrowsOneTooSmall) {
  EXPECT_EQ(CornersOf(Parse("M0 0A0 3 0 0 1 4 0")[0]), (Points{{0, 0}, {4, 0}}));
  const std::vector<Subpath> grown = Parse("M0 0A1 1 0 0 1 4 0");
  const Arc& arc = std::get<Arc>(grown[0].pieces[0]);
  EXPECT_NEAR(arc.radius, 2, 1e-12);
  EXPECT_LT(glm::length(arc.center - glm::dvec2(2, 0)), 1e-12);
}

TEST(ParseSvgPath, JoinsHalfCirclesToOneRingOpenOrClosed) {
  const std::string ring = "M500 1000A500 500 0 0 1 500 0A500 500 0 0 1 500 1000";
  for (const std::string end : {"", "Z"}) {
    const std::vector<Subpath> subpaths = Parse(ring + end);
    ASSERT_EQ(subpaths.size(), 1U);
    ASSERT_EQ(subpaths[0].pieces.size(), 1U);
    const Arc& arc = std::get<Arc>(subpaths[0].pieces[0]);
    EXPECT_EQ(arc.radius, 500);
    EXPECT_LT(glm::length(arc.center - glm::dvec2(500, 500)), 1e-9);
    EXPECT_EQ(arc.sweep, 2 * kPi);
    EXPECT_EQ(subpaths[0].closed, end == "Z");
  }
}

TEST(ParseSvgPath, RefitsEllipsesWithinTheTolerance) {
  // Half axes 500 and 800, turned by 30 degrees: the implicit equation is independent of the way
  // the arc is walked. |(x/a)^2 + (y/b)^2 - 1| <= 2 d / b for a point d off, with slack b = 500.
  const double c = std::cos(kPi / 6), s = std::sin(kPi / 6);
  const glm::dvec2 from(500 * c, 500 * s), to(-800 * s, 800 * c);
  char path[200];
  std::snprintf(path, sizeof path, "M%.12g %.12gA500 800 30 0 1 %.12g %.12g", from.x, from.y, to.x,
                to.y);
  const std::vector<Subpath> subpaths = Parse(path);
  ASSERT_EQ(subpaths.size(), 1U);
  EXPECT_GT(subpaths[0].pieces.size(), 1U);
  double length = 0;
  for (const Piece& piece : subpaths[0].pieces) {
    for (int i = 0; i <= 50; ++i) {
      const glm::dvec2 p = PointAt(piece, Length(piece) * i / 50);
      const double u = (c * p.x + s * p.y) / 500, v = (c * p.y - s * p.x) / 800;
      EXPECT_LE(std::abs(u * u + v * v - 1), 2.01 * 1.0 / 500);
    }
    length += Length(piece);
  }
  // A quarter of the perimeter by Ramanujan's second formula, good to 1e-6 here; the arcs stay
  // within 1 unit of the curve and do not wave, so lengths agree to about that.
  const double h = std::pow(300.0 / 1300, 2);
  EXPECT_NEAR(length, kPi * 1300 * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h))) / 4, 1.5);
}

/// Greatest distance of points of the Bezier curve (Bernstein sums) from the subpath.
double DistanceFromBezier(const std::vector<glm::dvec2>& p, const Subpath& subpath) {
  double greatest = 0;
  for (int i = 0; i <= 500; ++i) {
    const double t = i / 500.0, s = 1 - t;
    const glm::dvec2 q = p.size() == 3 ? s * s * p[0] + 2 * s * t * p[1] + t * t * p[2]
                                       : s * s * s * p[0] + 3 * s * s * t * p[1] +
                                             3 * s * t * t * p[2] + t * t * t * p[3];
    double nearest = 1e300;
    for (const Piece& piece : subpath.pieces) nearest = std::min(nearest, DistanceTo(piece, q));
    greatest = std::max(greatest, nearest);
  }
  return greatest;
}

TEST(ParseSvgPath, FollowsCurvesAbsoluteRelativeAndSmooth) {
  // By the standard, S mirrors the second control point of C, and T the control point of Q.
  const std::vector<glm::dvec2> c1 = {{0, 0}, {0, 400}, {300, 600}, {500, 300}};
  const std::vector<glm::dvec2> c2 = {{500, 300}, {700, 0}, {900, 0}, {1000, 500}};
  for (const char* path :
       {"M0 0C0 400 300 600 500 300S900 0 1000 500", "M0 0c0 400 300 600 500 300s400-300 500 200",
        "M0 0C0 400 300 600 500 300 700 0 900 0 1000 500"}) {
    const std::vector<Subpath> subpaths = Parse(path);
    ASSERT_EQ(subpaths.size(), 1U) << path;
    EXPECT_LE(DistanceFromBezier(c1, subpaths[0]), 1) << path;
    EXPECT_LE(DistanceFromBezier(c2, subpaths[0]), 1) << path;
  }
  const std::vector<glm::dvec2> q1 = {{0, 0}, {200, 600}, {400, 0}};
  const std::vector<glm::dvec2> q2 = {{400, 0}, {600, -600}, {800, 100}};
  for (const char* path : {"M0 0Q200 600 400 0T800 100", "M0 0q200 600 400 0t400 100"}) {
    const std::vector<Subpath> subpaths = Parse(path);
    ASSERT_EQ(subpaths.size(), 1U) << path;
    EXPECT_LE(DistanceFromBezier(q1, subpaths[0]), 1) << path;
    EXPECT_LE(DistanceFromBezier(q2, subpaths[0]), 1) << path;
  }
}

TEST(ParseSvgPath, MirrorsNothingWhenNoCurveOfTheKindCameBefore) {
  const std::vector<glm::dvec2> alone = {{0, 0}, {0, 0}, {300, 500}, {600, 0}};
  EXPECT_LE(DistanceFromBezier(alone, Parse("M0 0S300 500 600 0")[0]), 1);
  // After Q, S starts without a mirrored point; T after C is a straight line.
  const std::vector<glm::dvec2> after = {{400, 0}, {400, 0}, {700, 500}, {900, 0}};
  EXPECT_LE(DistanceFromBezier(after, Parse("M0 0Q200 600 400 0S700 500 900 0")[0]), 1);
  const std::vector<Subpath> line = Parse("M0 0C0 90 90 90 90 0L100 0T300 0");
  EXPECT_EQ(std::get<Line>(line[0].pieces.back()), (Line{{90, 0}, {300, 0}}));
}

TEST(ParseSvgPath, JoinsPiecesEndToEnd) {
  const std::vector<Subpath> subpaths =
      Parse("M0 0L100 0C200 0 200 100 100 100A50 50 0 0 0 100 200Q0 300-100 200Z");
  ASSERT_EQ(subpaths.size(), 1U);
  const std::vector<Piece>& pieces = subpaths[0].pieces;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& next = pieces[(i + 1) % pieces.size()];
    EXPECT_LT(glm::length(EndOf(pieces[i]) - StartOf(next)), 1e-6) << i;
  }
}

struct Broken {
  const char* path;
  std::size_t offset;
  const char* problem;
};

TEST(ParseSvgPath, NamesPlaceCauseAndCureOfABrokenPath) {
  for (const Broken& broken : {
           Broken{"M0 0B1 1", 4, "unknown path command 'B1 1'; use M L H V C S Q T A Z"},
           Broken{"M0 0 L1 1 \x01", 10, "unknown path command '?'; use M L H V C S Q T A Z"},
           Broken{"L1 1", 0, "the path starts with 'L'; start with M"},
           Broken{"1 1", 0, "unknown path command '1 1'; use M L H V C S Q T A Z"},
           Broken{"M0 nan", 3, "'nan' is no finite number; write one"},
           Broken{"M0 0Linf 1", 5, "'inf' is no finite number; write one"},
           Broken{"M0 0L1e999 1", 5, "'1e999' is no finite number; write one"},
           Broken{"M0 0L1", 6, "the path ends where a number is due; complete it"},
           Broken{"M0 0L- 1", 5, "'-' is no finite number; write one"},
           Broken{"M0 0L100001 0", 5, "number beyond 100 em; move the drawing to the letter box"},
           Broken{"M90000 0l90000 0", 14,
                  "point beyond 100 em; move the drawing to the letter box"},
           Broken{"M0 0A1 1 0 2 1 5 5", 11, "an arc flag is neither 0 nor 1; write one of these"},
           // To reach its end 200 half heights away the ellipse grows 100 times, to 5.5 million
           // wide.
           Broken{"M500 0A55000 50 0 0 1 500 10000", 7,
                  "arc grows beyond 100 em to reach its end; write radii that reach it"},
           Broken{"M0 0L1 1Z 5 5", 10, "a number after Z; write a command before it"},
       }) {
    try {
      Parse(broken.path);
      ADD_FAILURE() << broken.path << " was taken";
    } catch (const SvgPathError& error) {
      EXPECT_STREQ(error.what(), broken.problem) << broken.path;
      EXPECT_EQ(error.offset(), broken.offset) << broken.path;
    }
  }
}

TEST(ParseSvgPath, CountsCommandsAndPiecesOverAllPaths) {
  PathLimits limits;
  limits.commands = 3;
  ParseSvgPath("M0 0L1 1", limits);
  EXPECT_EQ(limits.commands, 1U);
  EXPECT_THROW(ParseSvgPath("M0 0L1 1", limits), SvgPathError);
  limits = {};
  limits.pieces = 2;
  EXPECT_THROW(ParseSvgPath("M0 0L1 0L1 1L0 1", limits), SvgPathError);
}

TEST(ParseSvgPath, EndsSoonOnHostilePaths) {
  std::string doubled = "M0 0", wild = "M0 0";
  for (int i = 0; i < 20000; ++i) doubled += "c0 0 0 0 0 0";
  for (int i = 0; i < 5000; ++i) wild += "C90000 90000-90000 90000 0 0";
  EXPECT_TRUE(Parse(doubled).empty());
  PathLimits limits;
  limits.tolerance = 1e-3;
  EXPECT_THROW(ParseSvgPath(wild, limits), SvgPathError);
}

TEST(ReadSvgNumber, StopsWhereTheNumberEnds) {
  std::size_t offset = 0;
  EXPECT_EQ(ReadSvgNumber("x -1.5e2.5", offset), std::nullopt);
  EXPECT_EQ(offset, 0U);
  EXPECT_EQ(ReadSvgNumber("-1.5e2.5", offset), -150.0);
  EXPECT_EQ(offset, 6U);
  EXPECT_EQ(ReadSvgNumber("-1.5e2.5", offset), 0.5);
  offset = 0;
  EXPECT_EQ(ReadSvgNumber("7em", offset), 7.0);  // e without digits is no exponent
  EXPECT_EQ(offset, 1U);
}

}  // namespace
}  // namespace moontrace
