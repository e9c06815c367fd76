#include "sim/view/view_words.h"

#include <gtest/gtest.h>

#include "sim/page_view/view_text.h"
#include "sim/view/view_messages.h"

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

TEST(ViewText, DropsWholeCharacters) {
  std::string text = "a\xc3\xa9\xe2\x82\xac";  // one, two and three bytes
  DropLast(text);
  EXPECT_EQ(text, "a\xc3\xa9");
  DropLast(text);
  EXPECT_EQ(text, "a");
  DropLast(text);
  DropLast(text);
  EXPECT_EQ(text, "");
  text = "\xe2\x82\xac\xc3\xa9";
  DropFirst(text);
  EXPECT_EQ(text, "\xc3\xa9");
}

/// Every letter is 10 points wide.
std::vector<std::string> Rows(const std::string& text, int room, std::size_t most) {
  return RowsOf(text, room, most,
                [](std::string_view row) { return 10 * static_cast<int>(row.size()); });
}

TEST(ViewText, BreaksBetweenWords) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(Rows("one two three", 130, 3), Texts({"one two three"}));
  EXPECT_EQ(Rows("one two three", 129, 3), Texts({"one two", "three"}));
  EXPECT_EQ(Rows("one two three four", 70, 2), Texts({"one two", "thre..."}));
  EXPECT_EQ(Rows("incomprehensible", 30, 2), Texts({"incomprehensible"}));
  EXPECT_EQ(Rows("", 30, 2), Texts({""}));
}

TEST(ViewText, OfMoreThanThereIsRoomForTheNewestStays) {
  using Texts = std::vector<std::string>;
  const auto newest = [](const Texts& texts) {
    return NewestRowsOf(texts, 90, 2,
                        [](std::string_view row) { return 10 * static_cast<int>(row.size()); });
  };
  EXPECT_EQ(newest({"One.", "Two.", "Three."}), Texts({"One. Two.", "Three."}));
  EXPECT_EQ(newest({"Old words.", "New ones."}), Texts({"New ones."}));
  EXPECT_EQ(newest({"Old.", "New words of three rows"}), Texts({"New words", "of thr..."}));
  EXPECT_EQ(newest({"Old.", ""}), Texts({"Old."}));
}

TEST(ViewWords, ANameMayFollowView) {
  EXPECT_EQ(ViewedNameOf(" View  Left Hand "), "Left Hand");
  EXPECT_EQ(ViewedNameOf("view"), "");
  EXPECT_EQ(ViewedNameOf("views"), std::nullopt);
  EXPECT_EQ(ViewedNameOf("review mug"), std::nullopt);
}

}  // namespace
}  // namespace moontrace
