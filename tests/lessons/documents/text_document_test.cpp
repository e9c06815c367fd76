#include "lessons/documents/text_document.h"

#include <gtest/gtest.h>

#include "lessons/documents/open_document.h"
#include "tests/lessons/documents/document_file.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

TEST(ReadPlainText, BlankLinesPartParagraphs) {
  const Document document = ReadPlainText("one\n\n \t\ntwo\r\n\r\nthree\fnext page\n", "t", false);
  ASSERT_EQ(document.blocks.size(), 4U);
  EXPECT_EQ(document.blocks[2].text, "three");
  EXPECT_EQ(document.blocks[3].text, "next page");
}

TEST(ReadPlainText, JoinsLinesThatWereBrokenForWantOfRoomOnly) {
  const Document document = OpenDocument(SourcePath("tests/data/documents/wrapped.txt"), {});
  ASSERT_EQ(document.blocks.size(), 4U);
  EXPECT_EQ(document.blocks[1].kind, BlockKind::kVerse);
  EXPECT_EQ(document.blocks[1].text,
            "The sun was shining on the sea,\nShining with all his might:");
  EXPECT_EQ(document.blocks[2].kind, BlockKind::kParagraph);
  EXPECT_EQ(document.blocks[2].text,
            "This paragraph was broken at some seventy characters, as mail and old books are, so "
            "that its lines are one paragraph that runs on to the end of it.");
  EXPECT_EQ(document.blocks[3].text, "- a list\n- of things");
}

TEST(ReadPlainText, ReadsMarksWhereAskedTo) {
  const char* text = "# Title\nwords\n> quoted\n>\n#no heading\n";
  const Document plain = ReadPlainText(text, "t", false);
  EXPECT_EQ(plain.blocks.size(), 1U);
  const Document marked = ReadPlainText(text, "t", true);
  ASSERT_EQ(marked.blocks.size(), 4U);
  EXPECT_EQ(marked.blocks[0].kind, BlockKind::kHeading);
  EXPECT_EQ(marked.blocks[0].text, "Title");
  EXPECT_EQ(marked.blocks[2].quotation, 1);
  EXPECT_EQ(marked.blocks[3].text, "#no heading");
  EXPECT_EQ(marked.blocks[3].kind, BlockKind::kParagraph);
}

TEST(ReadPlainText, RefusesEndlessParagraphs) {
  std::string text;
  for (std::size_t i = 0; i <= kMostBlocks; ++i) text += "a\n\n";
  EXPECT_EQ(RefusalOf([&] { ReadPlainText(text, "t.txt", false); }),
            "t.txt: holds more than 1000000 paragraphs; split it");
}

}  // namespace
}  // namespace moontrace
