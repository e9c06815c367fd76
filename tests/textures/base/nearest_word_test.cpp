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

TEST(NearestWord, IsEmptyWhenMoreThanAThirdMustChange) {
  EXPECT_EQ(NearestWord("abcdef", {"abcdxy"}), "abcdxy");  // two of six
  EXPECT_EQ(NearestWord("abcde", {"abcxy"}), "");          // two of five
  EXPECT_EQ(NearestWord("quit", {"gui"}), "");
  EXPECT_EQ(NearestWord("grade2", {"moon", "greek"}), "");
  EXPECT_EQ(NearestWord("a3", {"a4", "a5"}), "");
  EXPECT_EQ(NearestWord("xyz", {"csv", "page"}), "");
  EXPECT_EQ(NearestWord("", {"page"}), "");
}

TEST(NearestWord, CountsTwoNeighboursSwappedAsOneEdit) {
  EXPECT_EQ(NearestWord("tset", {"view", "text", "test"}), "test");
  EXPECT_EQ(NearestWord("leanr", {"lean-to", "learn"}), "learn");
}

TEST(NearestWord, TakesCapitalsForSmallLetters) {
  EXPECT_EQ(NearestWord("RIGHT-TO-LEFT", {"left-to-right", "right-to-left"}), "right-to-left");
  EXPECT_EQ(NearestWord("en_us", {"en", "en_US", "de_DE"}), "en_US");
  EXPECT_EQ(NearestWord("VER", {"left", "vertical"}), "vertical");
  EXPECT_EQ(NearestName("POLHME", {"openffboard", "Polhem"}), "Polhem");
}

TEST(NearestName, TakesTheFewestChanges) {
  EXPECT_EQ(NearestName("polehm", {"openffboard", "polhem", "spacemouse"}), "polhem");
  EXPECT_EQ(NearestName("rate", {"rat", "gate", "rate"}), "rate");
}

TEST(NearestName, IsEmptyWhenMoreThanAThirdMustChange) {
  EXPECT_EQ(NearestName("abcd", {"abyz"}), "");  // two changes of four bytes
  EXPECT_EQ(NearestName("ab", {"ax"}), "");
  EXPECT_EQ(NearestName("", {"a"}), "");
}

TEST(NearestName, DoesNotSearchForEndlessWords) {
  EXPECT_EQ(NearestName(std::string(1000000, 'a'), {"a"}), "");
}

}  // namespace
}  // namespace moontrace
