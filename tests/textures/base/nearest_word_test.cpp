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

}  // namespace
}  // namespace moontrace
