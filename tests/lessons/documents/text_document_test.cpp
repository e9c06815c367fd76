#include "lessons/documents/text_document.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

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

std::vector<std::string> TextsOf(const std::string& text) {
  std::vector<std::string> texts;
  for (const Block& block : ReadPlainText(text, "t", false).blocks) texts.push_back(block.text);
  return texts;
}

// Carroll, Through the Looking-Glass, as Project Gutenberg's books are broken: before a dash that
// stands without blanks a line ends early.
TEST(ReadPlainText, ALineThatEndsEarlyIsProseAllTheSame) {
  EXPECT_EQ(TextsOf("One thing was certain, that the white kitten had had nothing to do with it:\n"
                    "--it was the black kitten's fault entirely. For the white kitten had\n"
                    "been having its face washed by the old cat for the last quarter of an hour--\n"
                    "and bearing it pretty well, considering; so you see that it could not have\n"
                    "had any hand in the mischief.\n")
                .size(),
            1U);
  EXPECT_EQ(TextsOf("One thing was certain, that the white kitten had had nothing to do with it:\n"
                    "--it was the black kitten's fault entirely. For the white kitten had\n"
                    "been having its face washed by the old cat for the last quarter of an hour--\n"
                    "and bearing it pretty well, considering; so you see that it could not have\n"
                    "had any hand in the mischief.\n")
                .front()
                .find('\n'),
            std::string::npos);
}

// GNU General Public License 2, preamble: its paragraphs were broken to different widths.
TEST(ReadPlainText, AParagraphThatWasBrokenToLessIsProseToo) {
  EXPECT_EQ(
      TextsOf("  The licenses for most software are designed to take away your freedom to share,\n"
              "and to change it.  By contrast, the General Public License is intended to keep.\n"
              "\n"
              "  When we speak of free software, we are referring to freedom, not\n"
              "price.  Our General Public Licenses are designed to make sure that you\n"
              "have the freedom to distribute copies of free software (and charge for\n"
              "this service if you wish), that you receive source code or can get it\n"
              "if you want it, that you can change the software or use pieces of it\n"
              "in new free programs; and that you know you can do these things.\n")
          .at(1)
          .find('\n'),
      std::string::npos);
}

TEST(ReadPlainText, ParagraphsThatOnlyTheirFirstLinesPartArePartedThere) {
  EXPECT_EQ(TextsOf("   The keeper went up the narrow stair of his tower every evening in winter,\n"
                    "and lit the lamp that the ships at sea looked out for in the long nights.\n"
                    "   \"Good night,\" he said.\n"
                    "   Nobody answered him, since nobody else lived on the island, and the sea\n"
                    "was loud.\n"),
            (std::vector<std::string>{
                "The keeper went up the narrow stair of his tower every evening in winter, and lit "
                "the lamp that the ships at sea looked out for in the long nights.",
                "\"Good night,\" he said.",
                "Nobody answered him, since nobody else lived on the island, and the sea was "
                "loud."}));
  EXPECT_EQ(TextsOf("How doth the little crocodile\n    Improve his shining tail,\nAnd pour the "
                    "waters of the Nile\n    On every golden scale!\n")
                .front()
                .find("\n    Improve"),
            29U);
}

TEST(ReadPlainText, HyphensThatOnlyALinesEndHasAreNoSigns) {
  const std::string wide = "It was the keeper of the light who went up to the lamp each evening of";
  EXPECT_EQ(TextsOf(wide + " light-\nhouses and lamps, and no lighthouses without a lamp were "
                           "ever of use to well-\nknown ships of theirs, nor were those that had\n"
                           "\nThe end"),
            (std::vector<std::string>{wide + " lighthouses and lamps, and no lighthouses without a "
                                             "lamp were ever of use to wellknown ships of theirs, "
                                             "nor were those that had",
                                      "The end"}))
      << "one line in two ends so: the text is hyphenated";
  std::string long_text = wide + " well-\nknown";
  for (int i = 0; i < 60; ++i)
    long_text += " ships, which passed by in the night and in the morning too, and\nthen";
  EXPECT_EQ(TextsOf(long_text).front().substr(wide.size(), 11), " well-known");
}

std::vector<std::string> HeadingsOf(const std::string& text) {
  std::vector<std::string> headings;
  for (const ContentsEntry& entry : ContentsOf(ReadPlainText(text, "t", false))) {
    headings.push_back(entry.title);
  }
  return headings;
}
using Headings = std::vector<std::string>;

// Project Gutenberg's texts: four blank lines before a chapter, two behind its heading.
TEST(ReadPlainText, HeadingsOfChaptersStandApart) {
  EXPECT_EQ(
      HeadingsOf(
          "Title\n\n\n\n\nCHAPTER I.\nDown the Rabbit-Hole\n\n\nAlice was beginning.\n\nSTOP!\n\n"
          "she said.\n\n\n\n  Chapter 2: The Pool\n\nText.\n\n\nTHE POOL OF TEARS\n\nText.\n\n\n"
          "Part of it was\n\n\n*** END OF THE BOOK ***\n"),
      (Headings{"CHAPTER I. Down the Rabbit-Hole", "Chapter 2: The Pool", "THE POOL OF TEARS"}));
}

TEST(ReadPlainText, HeadingsOfChaptersAreInAnyAlphabet) {
  EXPECT_EQ(
      HeadingsOf(
          "\n\nГЛАВА ПЕРВАЯ\n\n\nБыло утро.\n\n\nГлава 2\n\n\nБыл день.\n\n\nÜBER DEN FLUẞ\n\n\n"
          "Es war.\n\n\nCapítulo II\n\n\nEra.\n\n\nSECCIÓN 2ª\n\n\nEra.\n"),
      (Headings{"ГЛАВА ПЕРВАЯ", "Глава 2", "ÜBER DEN FLUẞ", "Capítulo II", "SECCIÓN 2ª"}));
}

TEST(ReadPlainText, SmallLettersAndWordsForNumbersMakeNoHeading) {
  EXPECT_EQ(HeadingsOf(
                "\n\nÉTÉ à PARIS\n\n\nIl était.\n\n\nשלום עולם\n\n\nParte di un tutto\n\n\nEra.\n"),
            Headings());
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
