#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "textures/base/error.h"
#include "textures/base/utf8.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/louis.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

struct Language {
  const char* table;  ///< of liblouis
  const char* text;   ///< with the marks and spaces that its typesetters use
  const char32_t* opens;
  const char32_t* closes;
};

// Quotation marks that open in one language close in another.
const std::vector<Language> kLanguages = {
    {"fr-bfu-comp6.utb",
     "\u00AB\u00A0O\u00F9 vas-tu\u202F?\u00A0\u00BB demanda-t-elle\u202F; \u00AB Nulle part ! "
     "\u00BB\u2026 L\u2019\u00E9t\u00E9 : d\u00E9j\u00E0 10\u202F000 \u0153ufs (tr\u00E8s "
     "bien\u202F!)",
     U"\u00AB(", U"?;\u00BB!\u2026:)"},
    {"es-g1.ctb",
     "\u2014\u00BFQu\u00E9 hora es? \u2014pregunt\u00F3 \u00E9l. \u00AB\u00A1Ay, "
     "ni\u00F1a!\u00BB, dijo; \u00BFy t\u00FA?\u2026 El ping\u00FCino (\u00A1s\u00ED!)",
     U"\u00BF\u00A1\u00AB(", U"?.!\u00BB,;\u2026)"},
    {"Pl-Pl-g1.utb",
     "\u201EZa\u017C\u00F3\u0142\u0107 g\u0119\u015Bl\u0105 ja\u017A\u0144\u201D \u2013 "
     "rzek\u0142 \u0141ukasz; \u201ECzy \u017Ale?\u201D\u2026 \u0106ma!",
     U"\u201E", U"\u201D;?!\u2026"},
    {"ru-litbrl.ctb",
     "\u2014 \u00AB\u0421\u044A\u0435\u0448\u044C \u0435\u0449\u0451 "
     "\u0431\u0443\u043B\u043E\u043A\u00BB, \u2014 "
     "\u0441\u043A\u0430\u0437\u0430\u043B \u043E\u043D\u2026 "
     "\u0401\u043B\u043A\u0430; "
     "\u0437\u0430\u0301\u043C\u043E\u043A!",
     U"\u00AB", U"\u00BB,\u2026;!"},
    {"el.ctb",
     "\u00AB\u039E\u03B5\u03C3\u03BA\u03B5\u03C0\u03AC\u03B6\u03C9\u00BB, "
     "\u03B5\u03AF\u03C0\u03B5\u0387 \u03C4\u03B9 "
     "\u03BA\u03AC\u03BD\u03B5\u03B9\u03C2; "
     "\u039A\u03B1\u03BB\u03AC\u2026 \u038C,\u03C4\u03B9!",
     U"\u00AB", U"\u00BB,;\u2026!"},
    {"tr-g1.ctb",
     "\u201CPijamal\u0131 hasta ya\u011F\u0131z.\u201D \u0130stanbul\u2019da m\u0131? Evet; "
     "\u0131l\u0131k\u2026 "
     "\u00C7\u011E\u0130!",
     U"\u201C", U".\u201D?;\u2026!"},
    {"ar-ar-g1.utb",
     "\u0642\u0627\u0644: "
     "\u00AB\u0645\u0631\u062D\u0628\u0627\u064B \u0628\u0643\u0645\u061F\u00BB\u060C "
     "\u0630\u0647\u0628\u061B \u0643\u062A\u0627\u0628\u064C (\u0661\u0662)",
     U"\u00AB(", U":\u061F\u00BB\u060C\u061B)"},
    {"he-IL.utb",
     "\u05D4\u05D5\u05D0: \u201E\u05E9\u05DC\u05D5\u05DD!\u201D "
     "\u05D0\u05B5\u05D9\u05DA\u05B0 \u05D0\u05B7\u05EA\u05B8\u05BC\u05D4? "
     "\u05D1\u05D9\u05EA\u05BE\u05E1\u05E4\u05E8, "
     "\u05E6\u05D4\u05F4\u05DC\u2026",
     U"\u201E", U":!\u201D?,\u2026"},
    {"zhcn-g1.ctb",
     "\u4ED6\u8BF4\uFF1A\u201C\u4F60\u597D\uFF0C\u4E16\u754C\uFF01\u201D\u300A\u7EA2"
     "\u697C\u68A6\u300B\uFF08\u7B2C\u4E00\u7AE0\uFF09\u3001\u4E00\u4E8C\u3002",
     U"\u201C\u300A\uFF08", U"\uFF1A\uFF0C\uFF01\u201D\u300B\uFF09\u3001\u3002"},
    {"vi-vn-g1.ctb",
     "\u201CTi\u1EBFng Vi\u1EC7t: \u1EAF, \u1ED7!\u201D Nguy\u1EC5n h\u1ECFi: \u0111\u00E2u? "
     "\u1EDE \u0111\u00E2y\u2026",
     U"\u201C", U":,!\u201D?\u2026"},
    {"hi-in-g1.utb",
     "\u0928\u092E\u0938\u094D\u0924\u0947 \u0926\u0941\u0928\u093F\u092F\u093E! "
     "\u0915\u094D\u092F\u093E?",
     U"", U"!?"}};

std::vector<std::string> Words(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

/// The text and then its words in many orders, in one line. What stands alone stays where it is put
/// by the language.
std::string Shuffled(const Language& language, std::mt19937& random) {
  std::string text = language.text;
  const std::vector<std::string> words = Words(text);
  for (int i = 0; i < 20; ++i) {
    std::size_t at = random() % words.size();
    do {
      text += ' ' + words[at++];
    } while (at < words.size() && words[at].find_first_of("!;:?") == 0);
  }
  return text;
}

bool IsOneOf(const char32_t* marks, char32_t c) {
  return std::u32string_view(marks).find(c) != std::u32string_view::npos;
}

bool Told(const std::vector<Replacement>& list, std::size_t column) {
  return std::any_of(list.begin(), list.end(),
                     [column](const Replacement& one) { return one.column == column; });
}

/// Each character has a sign or is told to have none.
void ExpectNoLoss(const std::string& text, const Typeset& set) {
  std::vector<bool> written(text.size(), false);
  for (const TextPage& page : set.pages) {
    for (const PlacedGlyph& glyph : page.glyphs) {
      for (std::size_t i = glyph.source_begin; i < glyph.source_end; ++i) written[i] = true;
    }
  }
  std::size_t column = 0;
  for (std::size_t at = 0; at < text.size();) {
    char32_t c = 0;
    const std::size_t length = Decode(std::string_view(text).substr(at), c);
    ++column;
    const bool blank = IsSpaceSeparator(c);
    const bool told = Told(set.missing, column) || Told(set.folded, column);
    EXPECT_TRUE(blank || IsMark(c) || written[at] || told) << ToUtf8(c) << " at " << column;
    at += length;
  }
}

/// Rows begin with no mark that closes and end with none that opens.
void ExpectGoodEnds(const std::string& text, const Language& language, const Typeset& set) {
  const PlacedGlyph* before = nullptr;
  const auto character = [&text](const PlacedGlyph& glyph) {
    char32_t c = 0;
    Decode(std::string_view(text).substr(glyph.source_begin), c);
    return c;
  };
  for (const TextPage& page : set.pages) {
    for (const PlacedGlyph& glyph : page.glyphs) {
      const bool begins =
          before != nullptr && (glyph.line != before->line || &glyph == &page.glyphs[0]);
      if (begins && glyph.source_begin < glyph.source_end) {
        EXPECT_FALSE(IsOneOf(language.closes, character(glyph)))
            << "a row begins with " << ToUtf8(character(glyph));
      }
      if (begins && before->source_begin < before->source_end) {
        EXPECT_FALSE(IsOneOf(language.opens, character(*before)))
            << "a row ends with " << ToUtf8(character(*before));
      }
      before = &glyph;
    }
  }
}

/// The text as it was set, unless the page is too small for a letter.
std::optional<Typeset> Set(const std::string& text, const Script& script, const TypeStyle& style,
                           const PageSpec& page) {
  try {
    return SetText(text, script, style, page);
  } catch (const InputError& error) {
    const std::string line = error.what();
    EXPECT_NE(line.find("choose smaller letters"), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    return std::nullopt;
  }
}

void Try(const std::string& text, const Language& language, const Script& script,
         const std::string& table) {
  for (const int size_mm : {5, 8, 13, 30}) {
    TypeStyle style = DefaultStyle(1e-3 * size_mm, Relief::kEngraved, script);
    style.table = table;
    for (int side_mm = 40; side_mm <= 200; side_mm += 23) {
      const std::string side = std::to_string(side_mm);
      SCOPED_TRACE(script.name + " " + table + ", " + side + " mm, " + std::to_string(size_mm));
      const PageSpec page = FindPage(side + "x" + side);
      const std::optional<Typeset> set = Set(text, script, style, page);
      if (!set) continue;
      ExpectNoLoss(text, *set);
      // Twelve signs: more than a letter of six cells and three marks behind it.
      const double line = page.width - 2 * page.margin;
      if (line > 12 * 1.8 * style.size) ExpectGoodEnds(text, language, *set);
    }
  }
}

TEST(Languages, LoseNothingUntoldAndEndLinesWhereTheirMarksAllow) {
  std::mt19937 random(14);
  const Script moon = FindScript("moon"), braille = FindScript("braille");
  for (const Language& language : kLanguages) {
    const std::string text = Shuffled(language, random);
    bool in_moon = false;
    for (const char c : text) in_moon = in_moon || (c >= 'a' && c <= 'z');
    if (in_moon) Try(text, language, moon, "");
    try {
      const BrailleTable table(language.table);
    } catch (const LackError&) {
      continue;  // built without liblouis
    } catch (const InputError&) {
      continue;  // a liblouis without it
    }
    Try(text, language, braille, language.table);
  }
}

/// The dots of each cell, of one line.
std::string Cells(const std::string& text, const char* table) {
  const Script braille = FindScript("braille");
  TypeStyle style = DefaultStyle(0.005, Relief::kEngraved, braille);
  style.table = table;
  const Typeset set = SetText(text, braille, style, FindPage("a4"));
  EXPECT_EQ(set.missing_count, 0U) << text;
  std::string cells;
  for (const PlacedGlyph& glyph : set.pages.at(0).glyphs) {
    cells += (cells.empty() ? "" : " ") + braille.glyphs[glyph.glyph].name.substr(5);
  }
  return cells;
}

// Composed and decomposed text is the same text (Unicode, canonical equivalence).
TEST(Languages, ReadComposedAndDecomposedTextAlike) {
  const Script moon = FindScript("moon");
  const auto glyphs = [&moon](const std::string& text) {
    std::vector<std::size_t> all;
    const TypeStyle style = DefaultStyle(0.010, Relief::kEngraved, moon);
    const Typeset set = SetText(text, moon, style, FindPage("a4"));
    for (const PlacedGlyph& glyph : set.pages.at(0).glyphs) all.push_back(glyph.glyph);
    return all;
  };
  EXPECT_EQ(glyphs("ti\u1EBFng Vi\u1EC7t \u00E9t\u00E9 \u0142\u00F3d\u017A"),
            glyphs("tie\u0302\u0301ng Vie\u0323\u0302t e\u0301te\u0301 \u0142o\u0301dz\u0301"));
}

class LanguagesInBraille : public testing::Test {
 protected:
  void SetUp() override {
    try {
      const BrailleTable table("hi-in-g1.utb");
    } catch (const LackError&) {
      GTEST_SKIP() << "built without liblouis";
    }
  }
};

// Bharati Braille: na 1345, ma 134, sa 234, virama 4, ta 2345, the vowel sign e 15.
TEST_F(LanguagesInBraille, WritesTheVowelSignsOfHindi) {
  EXPECT_EQ(Cells("\u0928\u092E\u0938\u094D\u0924\u0947", "hi-in-g1.utb"),
            Cells("\u0928\u092E", "hi-in-g1.utb") + " 4 234 2345 15");
}

// Arabic Braille: tanwin fath 23. Hebrew: sheva 3 (the tables of liblouis). Russian: stress 4
// before the vowel.
TEST_F(LanguagesInBraille, WritesMarksThatTheTableHas) {
  EXPECT_EQ(Cells("\u0628\u064B", "ar-ar-g1.utb"), "12 23");
  EXPECT_EQ(Cells("\u05DA\u05B0", "he-IL.utb"), Cells("\u05DA", "he-IL.utb") + " 3");
  const std::string stressed = Cells("\u0437\u0430\u0301\u043C", "ru-litbrl.ctb");
  EXPECT_EQ(stressed, "1356 4 1 134");
}

// A Greek question mark is U+037E, which Unicode composes to a semicolon.
TEST_F(LanguagesInBraille, WritesTheQuestionMarkOfGreek) {
  EXPECT_EQ(Cells("\u03C4\u03B9;", "el.ctb"), "2345 24 26");
  EXPECT_EQ(Cells("\u03C4\u03B9\u037E", "el.ctb"), "2345 24 26");
}

}  // namespace
}  // namespace moontrace
