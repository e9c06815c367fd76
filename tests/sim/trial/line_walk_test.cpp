#include "sim/trial/line_walk.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/typeset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace moontrace {
namespace {

struct Sheet {
  Script script = FindScript("moon");
  TypeStyle style;
  Typeset set;
  std::vector<IntendedStroke> strokes;
  GrooveLinks links;
};

Sheet Linked(const std::string& text, LinkReach reach) {
  Sheet sheet;
  sheet.style = DefaultStyle(0.012, Relief::kEngraved, sheet.script);
  sheet.style.links.reach = reach;
  sheet.set = SetText(text, sheet.script, sheet.style, {"custom", 0.3, 0.3, 0.02});
  const TextPage& page = sheet.set.pages.front();
  sheet.strokes = IntendedStrokes(page, sheet.script, sheet.style);
  sheet.links = LinkPage(page, sheet.script, sheet.style);
  return sheet;
}

std::vector<Walk> WalksOf(const Sheet& sheet) {
  return WalksOf(sheet.strokes, sheet.set.pages.front(), sheet.links);
}

double LengthOf(const std::vector<Piece>& pieces) {
  double length = 0;
  for (const Piece& piece : pieces) length += Length(piece);
  return length;
}

TEST(LineWalk, LiftsAfterEachStrokeWhereThereAreNoLinks) {
  EXPECT_EQ(WalksOf(Linked("lak", LinkReach::kNone)).size(), 3u);
}

TEST(LineWalk, GoesThroughAWholeLineWithLinksAcrossWords) {
  const std::vector<Walk> walks = WalksOf(Linked("the ho\nla", LinkReach::kWords));
  ASSERT_EQ(walks.size(), 2u);     // one for each line
  EXPECT_EQ(walks[0].size(), 5u);  // bar, dot; crescent, ring; ring
}

TEST(LineWalk, LiftsBetweenWordsWhereOnlyLettersAreLinked) {
  EXPECT_EQ(WalksOf(Linked("la la", LinkReach::kLetters)).size(), 2u);
}

// The aim never jumps: each part begins where the one before ended. Samples of grooves are a
// quarter of the width apart, and a hop between touching grooves is a part itself.
TEST(LineWalk, IsOneWayWithoutJumps) {
  const Sheet sheet = Linked("the quick brown fox", LinkReach::kWords);
  for (const Walk& walk : WalksOf(sheet)) {
    glm::dvec2 at{0, 0};
    bool begun = false;
    for (const WalkStep& step : walk) {
      for (const std::vector<Piece>* part : {&step.path_P, &step.trace_P}) {
        for (const Piece& piece : *part) {
          if (begun) {
            EXPECT_LT(glm::distance(StartOf(piece), at), 1e-6);
          }
          at = EndOf(piece);
          begun = true;
        }
      }
    }
  }
}

TEST(LineWalk, TracesEveryStrokeWhole) {
  const Sheet sheet = Linked("the quick brown fox", LinkReach::kWords);
  std::size_t traced = 0;
  for (const Walk& walk : WalksOf(sheet)) {
    for (const WalkStep& step : walk) {
      EXPECT_EQ(step.stroke, traced++);
      EXPECT_NEAR(LengthOf(step.trace_P), LengthOf(sheet.strokes[step.stroke].spine_P), 1e-8);
    }
  }
  EXPECT_EQ(traced, sheet.strokes.size());
}

// A cross: the second stroke begins off the first, which is gone back to their crossing, and then
// along the second to its start.
TEST(LineWalk, GoesBackOverGroovesAlreadyTracedToABranch) {
  const auto bar = [](glm::dvec2 from, glm::dvec2 to) {
    IntendedStroke stroke;
    stroke.spine_P = {Line{from, to}};
    stroke.width = 1e-3;
    return stroke;
  };
  const std::vector<IntendedStroke> cross = {bar({0, 0}, {0.01, 0}),
                                             bar({0.005, 0.005}, {0.005, -0.005})};
  TextPage page;
  page.glyphs.resize(1);
  const std::vector<Walk> walks = LinkedWalks(cross, page, {});
  ASSERT_EQ(walks.size(), 1u);
  ASSERT_EQ(walks[0].size(), 2u);
  // half of the first back, half of the second up; the crossing is met within half a width
  EXPECT_NEAR(LengthOf(walks[0][1].path_P), 0.01, 2 * 0.5e-3);
}

}  // namespace
}  // namespace moontrace
