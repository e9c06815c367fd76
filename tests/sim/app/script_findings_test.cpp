#include "sim/app/script_findings.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

using Kind = ScriptFinding::Kind;

TEST(FindingTally, CountsAllAndKeepsAFewOfEachKind) {
  FindingTally tally(2, 100);
  for (std::size_t glyph = 10; glyph < 20; ++glyph) {
    tally.Add({Kind::kNarrowGap, glyph});
    tally.Add({Kind::kNarrowGap, glyph});
  }
  tally.Add({Kind::kSplit, 0});
  EXPECT_EQ(tally.total(), 21U);
  EXPECT_EQ(tally.of(Kind::kNarrowGap).findings, 20U);
  EXPECT_EQ(tally.of(Kind::kNarrowGap).glyphs, 10U);
  EXPECT_EQ(tally.of(Kind::kNarrowGap).examples, (std::vector<std::size_t>{10, 11, 12}));
  EXPECT_EQ(tally.of(Kind::kSplit).glyphs, 1U);
  EXPECT_FALSE(tally.Keeps(Kind::kNarrowGap));
  EXPECT_TRUE(tally.Keeps(Kind::kSplit));
  ASSERT_EQ(tally.kept().size(), 3U);
  EXPECT_EQ(tally.kept()[2].kind, Kind::kSplit);
}

TEST(FindingTally, KeepsNoMoreThanIsAllowedInAll) {
  FindingTally tally(1000, 7);
  for (std::size_t glyph = 0; glyph < 100; ++glyph) tally.Add({Kind::kOverlap, glyph});
  EXPECT_EQ(tally.kept().size(), 7U);
  EXPECT_EQ(tally.total(), 100U);
}

}  // namespace
}  // namespace moontrace
