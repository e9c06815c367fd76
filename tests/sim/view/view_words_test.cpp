#include "sim/view/view_words.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <memory>

#include "sim/view/view_messages.h"
#include "sim/view/view_text.h"

namespace moontrace {
namespace {

TEST(ViewWords, AreKnownWithSpacesAndCapitals) {
  EXPECT_EQ(ViewWordOf("zoom in"), ViewWord::kZoomIn);
  EXPECT_EQ(ViewWordOf("  Whole Page "), ViewWord::kWholePage);
  EXPECT_EQ(ViewWordOf("zoom"), std::nullopt);
  EXPECT_EQ(ViewWordOf("zoom into"), std::nullopt);
  EXPECT_EQ(ViewWordOf(" "), std::nullopt);
}

TEST(ViewWords, EachHasItsOwnSentence) {
  std::vector<std::string> sentences;
  for (const std::string& text : ViewWords()) {
    const auto word = ViewWordOf(text);
    ASSERT_TRUE(word) << text;
    const std::string sentence = say::ViewObeys(*word);
    EXPECT_LE(sentence.size(), 80U);
    EXPECT_EQ(sentence.back(), '.');
    for (const std::string& other : sentences) EXPECT_NE(sentence, other);
    sentences.push_back(sentence);
  }
}

TEST(ViewText, ShowsWhatMujocosLettersCan) {
  EXPECT_EQ(AsciiOf("size 20 mm", "?"), "size 20 mm");
  EXPECT_EQ(AsciiOf("caf\xc3\xa9 \xe2\x82\xac", "?"), "caf? ?");
  EXPECT_EQ(AsciiOf("a\tb\n", ""), "ab");
}

/// Every letter is 10 points wide.
std::vector<std::string> Rows(const std::string& text, int room, std::size_t most) {
  const auto context = std::make_unique<mjrContext>();
  for (int& width : context->charWidth) width = 10;
  return RowsOf(text, room, most, *context);
}

TEST(ViewText, BreaksBetweenWords) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(Rows("one two three", 130, 3), Texts({"one two three"}));
  EXPECT_EQ(Rows("one two three", 129, 3), Texts({"one two", "three"}));
  EXPECT_EQ(Rows("one two three four", 70, 2), Texts({"one two", "thre..."}));
  EXPECT_EQ(Rows("incomprehensible", 30, 2), Texts({"incomprehensible"}));
  EXPECT_EQ(Rows("", 30, 2), Texts({""}));
}

}  // namespace
}  // namespace moontrace
