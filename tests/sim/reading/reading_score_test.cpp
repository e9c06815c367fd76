#include "sim/reading/reading_score.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

TEST(ReadingScore, CountsWhatIsRight) {
  const std::vector<int> text{1, 2, kSpaceMark, 3, kLineEndMark};
  const ReadingScore score = Compare(text, text);
  EXPECT_EQ(score.right, 5U);
  EXPECT_EQ(score.signs, 3U);
  EXPECT_EQ(score.signs_right, 3U);
  EXPECT_EQ(score.wrong + score.missed + score.extra, 0U);
}

TEST(ReadingScore, TellsWrongMissedAndExtraApart) {
  const ReadingScore wrong = Compare({1, 2, 3}, {1, 9, 3});
  EXPECT_EQ(wrong.wrong, 1U);
  EXPECT_EQ(wrong.confusions.at({2, 9}), 1U);
  const ReadingScore missed = Compare({1, 2, kSpaceMark, 3}, {1, 2, 3});
  EXPECT_EQ(missed.missed, 1U);
  EXPECT_EQ(missed.signs_right, 3U);
  const ReadingScore extra = Compare({1, 2, 3}, {1, 2, 7, 3});
  EXPECT_EQ(extra.extra, 1U);
  EXPECT_EQ(extra.right, 3U);
}

// "kitten" to "sitting": Levenshtein's distance is 3, two changed and one more.
TEST(ReadingScore, IsLevenshteins) {
  const ReadingScore score =
      Compare({'k', 'i', 't', 't', 'e', 'n'}, {'s', 'i', 't', 't', 'i', 'n', 'g'});
  EXPECT_EQ(score.wrong, 2U);
  EXPECT_EQ(score.extra, 1U);
  EXPECT_EQ(score.missed, 0U);
  EXPECT_EQ(score.right, 4U);
}

TEST(ReadingScore, NothingReadIsAllMissed) {
  const ReadingScore score = Compare({1, 2}, {});
  EXPECT_EQ(score.missed, 2U);
  EXPECT_EQ(Compare({}, {1}).extra, 1U);
}

TEST(ReadingScore, AddsUp) {
  ReadingScore all = Compare({1, 2}, {1, 3});
  all += Compare({2}, {3});
  EXPECT_EQ(all.wrong, 2U);
  EXPECT_EQ(all.confusions.at({2, 3}), 2U);
}

}  // namespace
}  // namespace moontrace
