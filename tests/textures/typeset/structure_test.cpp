#include "textures/typeset/structure.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/textures/small_script.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

struct Read {
  LineMarks marks;
  std::string left;                // what is written, as in the text
  std::vector<std::string> links;  // their words
};

Read ReadLine(std::string_view text) {
  const Script script = SmallScript();
  Folder folder(text, script);
  std::vector<FoldedChar> line;
  for (std::vector<FoldedChar> part; folder.NextLine(part);) {
    line.insert(line.end(), part.begin(), part.end());
  }
  Read read;
  read.marks = TakeMarks(text, line);
  for (const FoldedChar& c : line) read.left += text.substr(c.begin, c.end - c.begin);
  for (const ByteRange& link : read.marks.links) {
    read.links.emplace_back(text.substr(link.begin, link.end - link.begin));
  }
  return read;
}

TEST(TakeMarks, OneToThreeHashesAndABlankBeginAHeading) {
  for (const char* text : {"# one two", "## one two", "###   one two"}) {
    EXPECT_EQ(ReadLine(text).marks.kind, LineKind::kHeading) << text;
    EXPECT_EQ(ReadLine(text).left, "one two") << text;
  }
  for (const char* text : {"#### one", "#one", " # one", "one # two", "#", "## ", "# \t"}) {
    EXPECT_EQ(ReadLine(text).marks.kind, LineKind::kPlain) << text;
    EXPECT_EQ(ReadLine(text).left, text);
  }
}

TEST(TakeMarks, AnAngleAndABlankBeginALineOfAQuotation) {
  EXPECT_EQ(ReadLine("> one").marks.kind, LineKind::kQuotation);
  EXPECT_EQ(ReadLine("> one").left, "one");
  EXPECT_EQ(ReadLine(">").marks.kind, LineKind::kQuotation);  // an empty line within one
  EXPECT_EQ(ReadLine("> # one").left, "# one");               // one mark a line
  EXPECT_EQ(ReadLine(">one").marks.kind, LineKind::kPlain);
  EXPECT_EQ(ReadLine("one > two").left, "one > two");
}

TEST(TakeMarks, WordsInBracketsWithAnAddressAreALink) {
  const Read read = ReadLine("see [the page](http://a.b/c_(d)) and [e](f).");
  EXPECT_EQ(read.left, "see the page and e.");
  EXPECT_EQ(read.links, (std::vector<std::string>{"the page", "e"}));
  EXPECT_EQ(ReadLine("# a [b](c)").marks.kind, LineKind::kHeading);
  EXPECT_EQ(ReadLine("# a [b](c)").links, std::vector<std::string>{"b"});
  EXPECT_EQ(ReadLine("[a]()").links, std::vector<std::string>{"a"});
}

TEST(TakeMarks, WhatIsNotWholeStaysAsItIs) {
  for (const char* text :
       {"[a] (b)", "[a](b", "a](b)", "[a)(b]", "[](b)", "[ ](b)", "[a](b(c)", "[", "](", "[a]"}) {
    EXPECT_EQ(ReadLine(text).left, text);
    EXPECT_TRUE(ReadLine(text).marks.links.empty()) << text;
  }
  EXPECT_EQ(ReadLine("[[a](b)").left, "[a");  // the nearest bracket opens
  EXPECT_EQ(ReadLine("[a[b]c](d)").links.size(), 0U);
}

// A bracket with an accent is another character; one that is written as several goes as a whole.
TEST(TakeMarks, ABackslashMakesAMarkACharacter) {
  for (const char* text : {"\\# one", "\\> one", "\\[one](two)", "\\\\# one", "\\\\[one](two)"}) {
    const Read read = ReadLine(text);
    EXPECT_EQ(read.marks.kind, LineKind::kPlain) << text;
    EXPECT_TRUE(read.links.empty()) << text;
    EXPECT_EQ(read.left, std::string(text).substr(1)) << text;
  }
  EXPECT_EQ(ReadLine("> \\[one](two)").left, "[one](two)");
  EXPECT_EQ(ReadLine("a\\ b \\one").left, "a\\ b \\one") << "elsewhere it is one itself";
}

TEST(TakeMarks, CountCharactersOfTheTextNotOfTheirForms) {
  EXPECT_TRUE(ReadLine("[\u0301a](b)").marks.links.empty());
  Script script = SmallScript();
  script.folds[U'['] = "ab";
  script.folds[U'#'] = "cd";
  const std::string text = "# [x](y)";
  Folder folder(text, script);
  std::vector<FoldedChar> line;
  ASSERT_TRUE(folder.NextLine(line));
  TakeMarks(text, line);
  ASSERT_EQ(line.size(), 1U);
  EXPECT_EQ(line[0].code, U'x');
}

// Quadratic work on these lengths would take minutes, beyond the tests' own limit of time.
TEST(TakeMarks, HostileLinesAreReadInLinearTime) {
  constexpr std::size_t kMany = 1'000'000;
  std::string opened(kMany, '['), half, nested;
  for (std::size_t i = 0; i < kMany / 4; ++i) half += "[a](";
  for (std::size_t i = 0; i < kMany / 4; ++i) nested += "[a](";
  nested += std::string(kMany / 4, ')');
  EXPECT_TRUE(ReadLine(opened).marks.links.empty());
  EXPECT_TRUE(ReadLine(half).marks.links.empty());
  EXPECT_EQ(ReadLine(nested).marks.links.size(), 1U);  // the first, whose address holds the rest
  EXPECT_TRUE(ReadLine(std::string(kMany, '#') + " a").marks.links.empty());
}

TypeStyle Structured(const Script& script) {
  TypeStyle style = DefaultStyle(0.010, Relief::kEngraved, script);
  style.structure.read = true;
  return style;
}

TEST(SetTextWithStructure, CountsAndLeavesMarksOut) {
  const Script script = SmallScript();
  const std::string text = "# one\n> two\n> three\n\nfour [five](x) six\n> seven\n# eight [n](y)";
  const Typeset set = SetText(text, script, Structured(script), FindPage("a4"));
  EXPECT_EQ(set.structure.headings, 2U);
  EXPECT_EQ(set.structure.quotations, 2U);
  EXPECT_EQ(set.structure.links, 2U);
  EXPECT_EQ(set.missing_count, 0U);  // brackets and hashes have no sign here
  std::string linked;
  for (const PlacedGlyph& placed : set.pages[0].glyphs) {
    if (placed.link) linked += text.substr(placed.source_begin, 1);
  }
  EXPECT_EQ(linked, "fiven");
}

TEST(SetTextWithStructure, WithoutItMarksAreCharactersLikeOthers) {
  const Script moon = FindScript("moon");
  TypeStyle style = DefaultStyle(0.012, Relief::kEngraved, moon);
  const Typeset plain = SetText("# 1", moon, style, FindPage("a4"));
  style.structure.heading_scale = 2;  // of no effect by itself
  const Typeset other = SetText("# 1", moon, style, FindPage("a4"));
  ASSERT_EQ(plain.pages[0].glyphs.size(), other.pages[0].glyphs.size());
  EXPECT_EQ(plain.structure.headings, 0U);
  EXPECT_GT(plain.missing_count + plain.folded_count, 0U);  // the hash is told
  EXPECT_EQ(plain.pages[0].glyphs.back().kind, LineKind::kPlain);
  EXPECT_EQ(plain.pages[0].glyphs.back().origin_P, other.pages[0].glyphs.back().origin_P);
}

}  // namespace
}  // namespace moontrace
