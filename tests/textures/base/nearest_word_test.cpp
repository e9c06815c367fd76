#include "textures/base/nearest_word.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

TEST(NearestWord, TakesTheFewestEdits) {
  EXPECT_EQ(NearestWord("trase", {"page", "trace", "replay"}), "trace");
  EXPECT_EQ(NearestWord("sise-mm", {"size-mm", "seed"}), "size-mm");
}

TEST(NearestWord, PrefersTheShortestThatItBegins) {
  EXPECT_EQ(NearestWord("size", {"json", "file", "size-mm"}), "size-mm");  // file is two edits off
  EXPECT_EQ(NearestWord("p", {"picture", "page", "press-n"}), "page");
}

TEST(NearestWord, IsEmptyWhenMoreThanHalfMustChange) {
  EXPECT_EQ(NearestWord("abcd", {"abxy"}), "abxy");  // two of four
  EXPECT_EQ(NearestWord("abcde", {"abxyz"}), "");    // three of five
  EXPECT_EQ(NearestWord("xyz", {"csv", "page"}), "");
  EXPECT_EQ(NearestWord("", {"page"}), "");
}

TEST(NearestWord, CountsTwoNeighboursSwappedAsOneEdit) {
  EXPECT_EQ(NearestWord("tset", {"view", "text", "test"}, 3), "test");
  EXPECT_EQ(NearestWord("leanr", {"lean-to", "learn"}, 3), "learn");
}

TEST(NearestWord, TakesFewerEditsWhereTheCallerAsks) {
  EXPECT_EQ(NearestWord("quit", {"gui"}), "gui");  // two of four
  EXPECT_EQ(NearestWord("quit", {"gui"}, 3), "");
}

TEST(NearestName, TakesTheFewestChanges) {
  EXPECT_EQ(NearestName("polehm", {"openffboard", "polhem", "spacemouse"}), "polhem");
  EXPECT_EQ(NearestName("rate", {"rat", "gate", "rate"}), "rate");
}

TEST(NearestName, IsEmptyWhenMoreThanHalfMustChange) {
  EXPECT_EQ(NearestName("abcd", {"wxyz"}), "");
  EXPECT_EQ(NearestName("ab", {"axx"}), "");  // two changes of two bytes
  EXPECT_EQ(NearestName("", {"a"}), "");
}

TEST(NearestName, DoesNotSearchForEndlessWords) {
  EXPECT_EQ(NearestName(std::string(1000000, 'a'), {"a"}), "");
}

}  // namespace
}  // namespace moontrace
