#include "textures/typeset/hyphenation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "textures/base/error.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/groove_links.h"
#include "textures/typeset/layout.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

bool HavePatterns() {
  try {
    const Hyphenation patterns("en_US");
    return true;
  } catch (const LackError&) {
    return false;
  } catch (const InputError&) {
    return false;
  }
}

/// The rows of a text as its glyphs' names, in lines of `width_mm`.
std::vector<std::string> Rows(const std::string& text, const std::string& language, int width_mm,
                              const char* script_name = "moon") {
  const Script script = FindScript(script_name);
  TypeStyle style = DefaultStyle(0.010, Relief::kEngraved, script);
  style.hyphenation = language;
  PageSpec page = FindPage(std::to_string(width_mm) + "x400");
  page.margin = 0.005;
  const Typeset set = SetText(text, script, style, page);
  std::vector<std::string> rows(set.pages.front().lines);
  for (const PlacedGlyph& glyph : set.pages.front().glyphs) {
    rows[glyph.line] += script.glyphs[glyph.glyph].name;
  }
  return rows;
}

// Where English words may be parted: by the dictionary (Merriam-Webster: al-pha-bet,
// in-for-ma-tion, moun-tain), not by the patterns alone.
TEST(Hyphenation, PartsWordsWhereTheDictionaryDoes) {
  if (!HavePatterns()) GTEST_SKIP() << "no libhyphen or no patterns";
  const Hyphenation patterns("en_US");
  const std::string text = "alphabet Information mountain a I strength";
  std::vector<Sign> signs;
  for (std::uint32_t i = 0; i < text.size(); ++i) {
    Sign sign;
    sign.begin = i;
    sign.end = i + 1;
    sign.space = text[i] == ' ';
    signs.push_back(sign);
  }
  patterns.Mark(text, signs);
  std::string parted;
  for (std::size_t i = 0; i < text.size(); ++i) {
    parted += text[i];
    if (signs[i].hyphen_after) parted += '-';
  }
  EXPECT_EQ(parted, "al-pha-bet In-for-ma-tion moun-tain a I strength");
}

TEST(Hyphenation, FillsRowsAndLosesNoLetter) {
  if (!HavePatterns()) GTEST_SKIP() << "no libhyphen or no patterns";
  std::string text;
  for (int i = 0; i < 4; ++i) text += "understanding information ";
  const std::vector<std::string> whole = Rows(text, "", 310), parted = Rows(text, "en_US", 310);
  EXPECT_LT(parted.size(), whole.size());
  std::string letters, expected;
  const std::string hyphen = "hyphen";
  int hyphens = 0;
  for (std::string row : parted) {
    if (row.size() >= hyphen.size() && row.substr(row.size() - hyphen.size()) == hyphen) {
      row.resize(row.size() - hyphen.size());
      ++hyphens;
    }
    letters += row;
  }
  for (const std::string& row : whole) expected += row;
  EXPECT_EQ(letters, expected);
  EXPECT_GT(hyphens, 0);
}

// A contraction is one sign: "the" of "mother" is not parted, whatever the patterns say.
TEST(Hyphenation, NeverPartsASign) {
  if (!HavePatterns()) GTEST_SKIP() << "no libhyphen or no patterns";
  for (int width = 40; width < 90; ++width) {
    for (const std::string& row : Rows("clothing clothing bathroom panther", "en_US", width)) {
      EXPECT_EQ(row.find("t"
                         "hyphen"),
                std::string::npos)
          << row;  // t-h
    }
  }
}

// What stands at a line's end within a word is a hyphen, of the text where it has one, on lines
// that hold two letters beside it; no hyphen begins a line.
TEST(Hyphenation, ShowsEveryBrokenWord) {
  if (!HavePatterns()) GTEST_SKIP() << "no libhyphen or no patterns";
  const std::string hyphen = "hyphen";
  const std::set<std::string> word_ends = {"g", "s", "w"};
  const std::string text = "extraordinary-looking circumstances mother-in-law amazing strengths";
  int broken = 0;
  for (int width = 52; width < 160; ++width) {
    for (const std::string& row : Rows(text, "en_US", width)) {
      EXPECT_NE(row.rfind(hyphen, 0), 0U) << width << " mm: " << row;
      const bool ends =
          row.size() > hyphen.size() && row.substr(row.size() - hyphen.size()) == hyphen;
      EXPECT_TRUE(ends || word_ends.count(row.substr(row.size() - 1)) > 0) << width << ": " << row;
      if (ends) ++broken;
      EXPECT_EQ(row.find(hyphen + hyphen), std::string::npos) << width << " mm: " << row;
    }
  }
  EXPECT_GT(broken, 100);
}

// On lines too short for the word's parts it is broken anywhere, and from there on every row holds
// as many letters as fit: where a hyphen would leave a letter alone that another fits beside, it is
// the hyphen that goes.
TEST(Hyphenation, FillsTheRowsOfAWordThatHadToBeBrokenElsewhere) {
  if (!HavePatterns()) GTEST_SKIP() << "no libhyphen or no patterns";
  const Script script = FindScript("moon");
  TypeStyle style = DefaultStyle(0.010, Relief::kEngraved, script);
  style.hyphenation = "en_US";
  const RowMetrics row = MeasureRows(script, style, 1);
  const std::size_t hyphen = script.Find("hyphen");
  const std::set<std::string> parts = {"cir", "cum", "stances", "cirhyphen", "cumhyphen"};
  int forced = 0;
  for (int width = 22; width < 100; ++width) {
    PageSpec page = FindPage(std::to_string(width) + "x900");
    page.margin = 0.001;
    const double line = page.width - 2 * page.margin;
    const Typeset set = SetText("circumstances", script, style, page);
    std::vector<std::vector<std::size_t>> rows(set.pages.at(0).lines);
    for (const PlacedGlyph& glyph : set.pages[0].glyphs) rows[glyph.line].push_back(glyph.glyph);
    const auto length = [&row](const std::vector<std::size_t>& glyphs) {
      double pen = 0;
      for (std::size_t i = 0; i < glyphs.size(); ++i) {
        pen += i + 1 < glyphs.size() ? row.advance[glyphs[i]] : row.extent[glyphs[i]];
      }
      return pen;
    };
    bool broken = false;
    std::size_t letters = 0;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      std::vector<std::size_t> held = rows[r];
      std::string name;
      for (const std::size_t glyph : held) name += script.glyphs[glyph].name;
      const bool shown = held.back() == hyphen;
      if (shown) held.pop_back();
      letters += held.size();
      broken = broken || parts.count(name) == 0;
      if (r + 1 == rows.size()) break;
      // no hyphen is missing but for a second letter
      EXPECT_TRUE(shown || held.size() > 1 || length({held[0], hyphen}) > line) << width;
      if (!broken) continue;
      ++forced;
      // one more, unless that would leave the last letter alone
      if (rows[r + 1].size() == 2 && r + 2 == rows.size()) continue;
      held.push_back(rows[r + 1][0]);
      if (shown || held.size() > 2) held.push_back(hyphen);
      EXPECT_GT(length(held), line) << width << " mm: " << name;
    }
    EXPECT_EQ(letters, 13U) << width;
  }
  EXPECT_GT(forced, 50);
}

TEST(Hyphenation, PrefersTheHyphenOfTheText) {
  if (!HavePatterns()) GTEST_SKIP() << "no libhyphen or no patterns";
  // "well-infor-" has room on the first line, all of "information" on the second.
  const std::vector<std::string> rows = Rows("well-information", "en_US", 175);
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows.front(), "wellhyphen");
}

TEST(Hyphenation, NamesTheDebianPackageOfALanguage) {
  if (!HavePatterns()) GTEST_SKIP() << "no libhyphen or no patterns";
  const auto told = [](const std::string& language) -> std::string {
    try {
      const Hyphenation patterns(language);
    } catch (const InputError& error) {
      return error.what();
    }
    return "installed";
  };
  // Debian 12 has one package for all German, one for each English and Portuguese.
  const std::vector<std::pair<std::string, std::string>> packages = {{"de_DE", "hyphen-de"},
                                                                     {"pt_BR", "hyphen-pt-br"},
                                                                     {"en_GB", "hyphen-en-gb"},
                                                                     {"nb_NO", "hyphen-no"}};
  for (const auto& [language, package] : packages) {
    const std::string said = told(language);
    EXPECT_TRUE(said == "installed" ||
                said.find("apt install " + package + "\"") != std::string::npos)
        << said;
  }
  EXPECT_EQ(told("tlh").find("apt"), std::string::npos) << told("tlh");
}

TEST(Hyphenation, UnknownLanguagesNameTheNearest) {
  if (!HavePatterns()) GTEST_SKIP() << "no libhyphen or no patterns";
  try {
    const Hyphenation patterns("en_SU");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean en_US?"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(Hyphenation("../../../etc/passwd"), InputError);
  try {
    const Hyphenation patterns("EN_us");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean en_US?"), std::string::npos)
        << error.what();
  }
}

Typeset Headed(const std::string& text, const std::string& head, bool numbers,
               LineDirection lines = LineDirection::kLeftToRight, bool structure = false) {
  Script script = FindScript("moon");
  TypeStyle style = DefaultStyle(0.010, Relief::kEngraved, script);
  style.running_head = head;
  style.page_numbers = numbers;
  style.lines = lines;
  style.structure.read = structure;
  if (lines == LineDirection::kAlternate) AddGuides(script, style);
  return SetText(text, script, style, FindPage("160x120"));
}

std::string HeadOf(const TextPage& page, const Script& script) {
  std::string head;
  for (const PlacedGlyph& glyph : page.glyphs) {
    if (glyph.kind == LineKind::kHead) head += script.glyphs[glyph.glyph].name + " ";
  }
  return head;
}

TEST(PageHead, NumbersEveryPageInItsFirstRow) {
  const Script script = FindScript("moon");
  std::string text;
  for (int i = 0; i < 40; ++i) text += "no moon\n";
  const Typeset plain = Headed(text, "", false), set = Headed(text, "moon", true);
  ASSERT_GT(set.pages.size(), plain.pages.size());  // a row of each page is taken
  for (std::size_t p = 0; p < set.pages.size(); ++p) {
    const TextPage& page = set.pages[p];
    std::string expected = "m o o n numeral ";
    for (const char digit : std::to_string(p + 1)) {
      expected += std::string(1, digit == '0' ? 'j' : static_cast<char>('a' + digit - '1')) + " ";
    }
    EXPECT_EQ(HeadOf(page, script), expected);
    double right = 0;
    for (const PlacedGlyph& glyph : page.glyphs) {
      EXPECT_EQ(glyph.kind == LineKind::kHead, glyph.line == 0);
      if (glyph.kind != LineKind::kHead) continue;
      EXPECT_EQ(glyph.source_begin, glyph.source_end);
      double far = 0;
      for (const Stroke& stroke : script.glyphs[glyph.glyph].strokes) {
        for (const Piece& piece : stroke.pieces) far = std::max(far, BoundsOf(piece).max.x);
      }
      right = std::max(right, glyph.origin_P.x + set.style.size * far);
    }
    EXPECT_NEAR(right, set.page.width - set.page.margin, 1e-9);
  }
}

// The text itself is what it is without a head, in every direction and with headings.
TEST(PageHead, LeavesTheTextAsItIs) {
  std::string text;
  for (int i = 0; i < 30; ++i) text += i % 4 == 2 ? "# it is\n" : "the moon is bright tonight\n";
  for (const LineDirection lines : {LineDirection::kLeftToRight, LineDirection::kRightToLeft,
                                    LineDirection::kVertical, LineDirection::kAlternate}) {
    const auto glyphs = [&](const Typeset& set) {
      std::vector<std::size_t> signs;
      for (const TextPage& page : set.pages) {
        const Box sheet = page.sheet_P;
        for (const PlacedGlyph& glyph : page.glyphs) {
          EXPECT_TRUE(glyph.origin_P.y >= sheet.min.y && glyph.origin_P.y <= sheet.max.y);
          EXPECT_LT(glyph.line, page.lines);
          if (glyph.kind != LineKind::kHead && glyph.source_begin < glyph.source_end) {
            signs.push_back(glyph.glyph);
          }
        }
      }
      return signs;
    };
    const Typeset headed = Headed(text, "it", true, lines, true);
    EXPECT_EQ(glyphs(headed), glyphs(Headed(text, "", false, lines, true)));
    for (const TextPage& page : headed.pages) {
      // none stands alone at a page's foot
      EXPECT_NE(page.glyphs.back().kind, LineKind::kHeading) << NameOf(lines);
    }
  }
}

// The last line of a page leads nowhere, whether or not the next page has a head.
TEST(PageHead, NoGuideLineLeadsOffThePage) {
  std::string text;
  for (int i = 0; i < 40; ++i) text += "the moon is bright ";
  Script script = FindScript("moon");
  const Typeset set = Headed(text, "moon", true, LineDirection::kAlternate);
  AddGuides(script, set.style);
  ASSERT_GT(set.pages.size(), 2U);
  for (const TextPage& page : set.pages) {
    const std::string last = script.glyphs[page.glyphs.back().glyph].name;
    EXPECT_TRUE(last != "guide-right" && last != "guide-left") << last;
  }
}

TEST(PageHead, IsNotLinkedToThePagesNumber) {
  const Script script = FindScript("moon");
  Typeset set = Headed("moon", "moon", true);
  set.style.links.reach = LinkReach::kWords;
  const TextPage& page = set.pages.front();
  const GrooveLinks links = *LinksOf(page, script, set.style);
  int between = 0;
  for (const GrooveLink& link : links.links) {
    if (link.from == link.to) continue;  // joins a sign's own strokes
    EXPECT_NE(page.glyphs[link.from].kind, LineKind::kHead);
    ++between;
  }
  EXPECT_EQ(between, 3);  // of the text alone
}

TEST(PageHead, WhatDoesNotFitIsToldInOneLine) {
  EXPECT_THROW(Headed("moon", "two\nlines", true), InputError);
  EXPECT_THROW(Headed("moon", "   ", true), InputError);
  EXPECT_THROW(Headed("moon", std::string(100, 'm'), true), InputError);
  const Script script = FindScript("moon");
  TypeStyle style = DefaultStyle(0.010, Relief::kEngraved, script);
  style.page_numbers = true;
  EXPECT_THROW(SetText("moon", script, style, FindPage("100x35")), InputError);  // one row only
}

TEST(PageHead, NamesWhatWasAskedFor) {
  const auto told = [](const std::string& head, bool numbers, std::vector<std::string> only,
                       const char* page) -> std::string {
    const Script script = FindScript("moon");
    TypeStyle style = DefaultStyle(0.010, Relief::kEngraved, script);
    style.running_head = head;
    style.page_numbers = numbers;
    style.only = std::move(only);
    try {
      SetText("o", script, style, FindPage(page));
    } catch (const InputError& error) {
      return error.what();
    }
    return "set";
  };
  const std::string untaught = told("", true, {"m", "o", "n"}, "160x120");
  EXPECT_NE(untaught.find("page numbers: '1' is not among the signs taught (--only)"),
            std::string::npos)
      << untaught;
  EXPECT_EQ(told("", true, {"o", "a", "numeral"}, "160x120"), "set");
  const std::string narrow = told("", true, {}, "35x120");
  EXPECT_EQ(narrow.rfind("page numbers need", 0), 0U) << narrow;
  EXPECT_EQ(narrow.find("head"), std::string::npos) << narrow;
  EXPECT_EQ(told("mmmm", false, {}, "35x120").rfind("the running head needs", 0), 0U);
}

}  // namespace
}  // namespace moontrace
