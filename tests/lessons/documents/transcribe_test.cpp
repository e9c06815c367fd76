#include "lessons/documents/transcribe.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "lessons/documents/html_tree.h"
#include "lessons/documents/open_document.h"
#include "lessons/documents/zip_archive.h"
#include "tests/source_path.h"
#include "textures/base/utf8.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

Document Of(std::vector<Block> blocks) {
  Document document;
  document.blocks = std::move(blocks);
  return document;
}

Block Paragraph(const std::string& text, std::vector<DocumentMark> marks = {}) {
  Block block;
  block.text = text;
  block.marks = std::move(marks);
  return block;
}

/// The text as it stands on pages: what is read of the marks is gone.
struct Pages {
  Typeset set;
  std::string signs;  // source bytes of all glyphs, in order
  std::vector<bool> covered;
};

Pages PagesOf(const std::string& text) {
  const Script script = FindScript("moon");
  TypeStyle style = DefaultStyle(0.012, Relief::kEngraved, script);
  style.structure.read = true;
  Pages pages{SetText(text, script, style, FindPage("a4")), {}, std::vector<bool>(text.size())};
  for (const TextPage& page : pages.set.pages) {
    for (const PlacedGlyph& glyph : page.glyphs) {
      pages.signs += text.substr(glyph.source_begin, glyph.source_end - glyph.source_begin);
      for (std::size_t i = glyph.source_begin; i < glyph.source_end; ++i) pages.covered[i] = true;
    }
  }
  return pages;
}

TEST(Transcribe, WhatLooksLikeAMarkIsNone) {
  for (const std::string text : {"# one", "> two", "\\# three", "\\\\> four", "\\[five](x)",
                                 "a [six](x) b", "[[7](x)", "]("}) {
    const Pages pages = PagesOf(Transcribe(Of({Paragraph(text)})).text);
    EXPECT_EQ(
        pages.set.structure.headings + pages.set.structure.quotations + pages.set.structure.links,
        0U)
        << text;
    std::string expected = text;
    std::erase(expected, ' ');
    for (const Replacement& one : pages.set.missing) {
      if (one.was.size() == 1) std::erase(expected, one.was[0]);
    }
    EXPECT_EQ(pages.signs, expected) << text;
  }
}

TEST(Transcribe, LinksAreMarkedOnEachOfTheirLines) {
  Block verse = Paragraph("see\nhere now", {{MarkKind::kLink, 0, 8, "a b(c)"}});
  verse.kind = BlockKind::kVerse;
  EXPECT_EQ(Transcribe(Of({verse})).text, "[see](ab%28c%29)\n[here](ab%28c%29) now\n");
  EXPECT_EQ(Transcribe(Of({Paragraph("[1] a[b]c", {{MarkKind::kLink, 0, 3, "x"},
                                                   {MarkKind::kLink, 4, 9, "y"}})}))
                .text,
            "[[1](x)] a[b]c\n");
}

// Adorned letters at the beginnings of chapters, as Project Gutenberg's books have them.
TEST(Transcribe, APictureThatBeginsAWordIsItsLetter) {
  EXPECT_EQ(Transcribe(Of({Paragraph("There was", {{MarkKind::kPicture, 0, 1, "t.png"}})})).text,
            "There was\n");
  EXPECT_EQ(
      Transcribe(Of({Paragraph("\xC3\x89t\xC3\xA9", {{MarkKind::kPicture, 0, 2, "e.png"}})})).text,
      "\xC3\x89t\xC3\xA9\n");
  EXPECT_EQ(Transcribe(Of({Paragraph("A door", {{MarkKind::kPicture, 0, 1, "a.png"}})})).text,
            "(picture: A) door\n");
}

TEST(Transcribe, TellsWhereEachBlockBegins) {
  Block heading = Paragraph("Title");
  heading.kind = BlockKind::kHeading;
  heading.level = 5;
  Block quoted = Paragraph("a\nb");
  quoted.quotation = 2;
  const Transcription written = Transcribe(Of({heading, quoted, Paragraph("c")}));
  EXPECT_EQ(written.text, "### Title\n\n> a\n> b\n\nc\n");
  EXPECT_EQ(written.begins, (std::vector<std::size_t>{0, 11, 20}));
}

/// How often each character that has ink stands in a text; of `covered` bytes only, if given.
void CountVisible(const std::string& text, const std::vector<bool>* covered,
                  std::map<std::string, std::size_t>& counts) {
  for (std::size_t at = 0; at < text.size();) {
    char32_t c = 0;
    const std::size_t length = Decode(std::string_view(text).substr(at), c);
    ASSERT_GT(length, 0U);
    const bool inked = c > U' ' && !IsSpaceSeparator(c);
    if (inked && (covered == nullptr || (*covered)[at])) ++counts[text.substr(at, length)];
    at += length;
  }
}

// Every visible character of every fixture is in a glyph's range or in the list of what has no
// sign.
TEST(Transcribe, NothingOfADocumentIsLostOnItsPages) {
  for (const char* name :
       {"page.html", "wrapped.txt", "latin.txt", "lighthouse-2.epub", "lighthouse-3.epub"}) {
    const bool plain = std::string(name).find(".txt") != std::string::npos;
    if (!plain && (!CanReadHtml() || !CanReadZip())) continue;
    const Document document =
        OpenDocument(SourcePath("tests/data/documents/" + std::string(name)), {});
    const Transcription written = Transcribe(document);
    ASSERT_EQ(written.begins.size(), document.blocks.size());
    const Pages pages = PagesOf(written.text);
    std::map<std::string, std::size_t> wanted, found;
    for (const Block& block : document.blocks) CountVisible(block.text, nullptr, wanted);
    CountVisible(written.text, &pages.covered, found);
    ASSERT_LT(pages.set.missing_count, 1000U);  // of which all are kept
    for (const Replacement& one : pages.set.missing) CountVisible(one.was, nullptr, found);
    for (const auto& [character, count] : wanted) {
      EXPECT_GE(found[character], count) << name << ": " << character;
    }
  }
}

}  // namespace
}  // namespace moontrace
