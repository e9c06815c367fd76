#include "textures/typeset/braille_writer.h"

#include <gtest/gtest.h>

#include "textures/base/error.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/glyph_group.h"
#include "textures/typeset/make_writer.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

class Braille : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      BrailleTable("en-ueb-g1.ctb");
    } catch (const LackError&) {
      GTEST_SKIP() << "built without liblouis";
    }
  }
  const Script script_ = FindScript("braille");

  Typeset Set(std::string_view text, double grade = 1, const std::string& table = "",
              const PageSpec& page = FindPage("a4")) const {
    TypeStyle style = DefaultStyle(script_.size, Relief::kEngraved, script_);
    style.grade = grade;
    style.table = table;
    return SetText(text, script_, style, page);
  }
  std::string Names(const Typeset& set) const {
    std::string names;
    for (const PlacedGlyph& placed : set.pages.front().glyphs) {
      names += (names.empty() ? "" : " ") + script_.glyphs[placed.glyph].name;
    }
    return names;
  }
};

// Unified English Braille: h is dots 125, i 24; "the" contracted 2346; dot 6 before a capital.
TEST_F(Braille, WritesByTheTableOfTheGrade) {
  EXPECT_EQ(Names(Set("hi")), "dots-125 dots-24");
  EXPECT_EQ(Names(Set("The", 1)), "dots-6 dots-2345 dots-125 dots-15");
  EXPECT_EQ(Names(Set("The", 2)), "dots-6 dots-2346");
}

TEST_F(Braille, TakesAnyTableAndEightDots) {
  // Computer Braille writes a capital with dot 7 in the letter's own cell.
  EXPECT_EQ(Names(Set("A", 1, "en-us-comp8-ext.utb")), "dots-17");
}

// Standard sizes (Marburg Medium, and near NLS 800): dots 2.5 mm apart, cells 6 mm, lines 10 mm,
// dots about 1.5 mm wide and 0.5 mm high.
TEST_F(Braille, HasPaperSizesByDefault) {
  const Typeset set = Set("ab\nc");
  const auto& glyphs = set.pages.front().glyphs;
  EXPECT_NEAR(glyphs[1].origin_P.x - glyphs[0].origin_P.x, 0.006, 1e-12);
  EXPECT_NEAR(glyphs[0].origin_P.y - glyphs[2].origin_P.y, 0.010, 1e-12);
  EXPECT_NEAR(set.style.width, 0.0015, 1e-12);
  EXPECT_NEAR(set.style.depth, 0.0005, 1e-12);
  const Group cell = BuildGlyph(script_.glyphs[script_.Find("dots-14")], set.style);
  ASSERT_EQ(cell.elements.size(), 2U);
  const Box left = BoundsOf(cell.elements[0]), right = BoundsOf(cell.elements[1]);
  EXPECT_NEAR(right.min.x - left.min.x, 0.0025, 1e-9);
  EXPECT_NEAR(left.max.x - left.min.x, 0.0015, 1e-9);
  EXPECT_NEAR(left.max.y - left.min.y, 0.0015, 1e-9);
}

TEST_F(Braille, DotsHaveTheirFullHeightOnRidgesToo) {
  const TypeStyle style = DefaultStyle(script_.size, Relief::kEmbossed, script_);
  const Group cell = BuildGlyph(script_.glyphs[script_.Find("dots-1")], style);
  EXPECT_NEAR(Evaluate(cell.elements[0], {0, 0.005}).height, 0.0005, 1e-9);
}

TEST_F(Braille, KeepsTheBytesOfEachCell) {
  const Typeset set = Set("\u00E9The", 2);
  const auto& glyphs = set.pages.front().glyphs;
  EXPECT_EQ(glyphs.back().source_begin, 2U);
  EXPECT_EQ(glyphs.back().source_end, 5U);
  std::size_t end = 0;
  for (const PlacedGlyph& glyph : glyphs) {
    EXPECT_EQ(glyph.source_begin, end);  // no byte of this text is without a cell
    end = glyph.source_end;
  }
}

TEST_F(Braille, ReportsWhatTheTableLacks) {
  const Typeset set = Set("a\u65E5b");
  EXPECT_EQ(Names(set), "dots-1 dots-12");
  ASSERT_EQ(set.missing_count, 1U);
  EXPECT_EQ(set.missing[0].was, "\u65E5");
  EXPECT_EQ(set.missing[0].column, 2U);
}

TEST_F(Braille, WrapsAtSpacesAndKeepsIndicatorsWithTheirLetter) {
  // 30 mm between the margins hold 5 cells (4 steps of 6 mm and a dot's column of 2.5 mm).
  const Typeset set = Set("abc def", 1, "", {"custom", 0.05, 0.1, 0.01});
  EXPECT_EQ(set.pages.front().lines, 2U);
  const Typeset broken = Set("abcdEf", 1, "", {"custom", 0.05, 0.1, 0.01});
  // a b c d, then the capital indicator goes with its letter to the next line.
  EXPECT_EQ(broken.pages.front().glyphs[3].line, 0U);
  EXPECT_EQ(broken.pages.front().glyphs[4].line, 1U);
}

TEST_F(Braille, RefusesWhatOnlyOtherScriptsHave) {
  TypeStyle style = DefaultStyle(script_.size, Relief::kEngraved, script_);
  style.only = {"dots-1"};
  EXPECT_THROW(MakeWriter(script_, style), InputError);
  style.only.clear();
  style.h_form = "arc";
  EXPECT_THROW(MakeWriter(script_, style), InputError);
  style.h_form.clear();
  style.grade = 0.5;
  EXPECT_THROW(MakeWriter(script_, style), InputError);
  const Script moon = FindScript("moon");
  TypeStyle tabled = DefaultStyle(0.012, Relief::kEngraved, moon);
  tabled.table = "en-ueb-g1.ctb";
  EXPECT_THROW(MakeWriter(moon, tabled), InputError);
}

// Dots 7 and 8 hang below the base line, into the margin but not off the sheet.
TEST_F(Braille, DotsBelowTheLineStayOnTheSheet) {
  const PageSpec narrow{"custom", 0.05, 0.0052, 0.0001};
  EXPECT_NO_THROW(Set("a", 1, "en-us-comp8-ext.utb", narrow));
  EXPECT_THROW(Set("A", 1, "en-us-comp8-ext.utb", narrow), InputError);
}

std::string RulesError(const std::string& more) {
  const char* svg =
      "<svg><defs><font horiz-adv-x='1200'><font-face units-per-em='1000' cap-height='1000'/>"
      "<glyph unicode='\u2801' glyph-name='dots-1'><circle cx='0' cy='1000' r='150'/></glyph>"
      "</font></defs></svg>";
  const std::string toml =
      "title='B'\nauthor='x'\nlicence='CC0-1.0'\nstroke_width_em=0.3\nspace_advance_em=1.2\n"
      "grades=[1]\n" +
      more;
  try {
    const Script script = ParseScript(svg, "b.svg", toml, "b.toml");
    return script.braille_tables.empty() ? "no tables" : script.braille_tables.begin()->second;
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(BrailleRules, NameATableForEachGrade) {
  EXPECT_EQ(RulesError("[[braille]]\ngrade=1\ntable='a.ctb'\n"), "a.ctb");
  EXPECT_EQ(RulesError("[[braille]]\ngrade=2\ntable='a.ctb'\n"),
            "b.toml:8:7: grade: not among the grades above; add it there or correct it");
  EXPECT_EQ(RulesError("[[braille]]\ngrade=1\ntable=''\n"),
            "b.toml:9:7: table: empty; name a table of liblouis");
  EXPECT_EQ(RulesError("[[braille]]\ngrade=1\ntable='a'\n[[braille]]\ngrade=1\ntable='b'\n"),
            "b.toml:11:7: grade: a second table for this grade; keep one");
}

TEST(BrailleRules, GiveUsualMeasures) {
  EXPECT_EQ(RulesError("size_mm=0\n"),
            "b.toml:7:9: size_mm: not above 0 and up to 1000 mm; correct it");
  EXPECT_EQ(RulesError("depth_em=2\n"),
            "b.toml:7:10: depth_em: not above 0 and up to 1 em; correct it");
}

// German marks by Unified English Braille: “ is dots 236, ” dots 356, ‘ 6 236, ’ 6 356.
TEST_F(Braille, ClosesWhatALowQuotationMarkOpens) {
  for (const double grade : {1.0, 2.0}) {
    EXPECT_EQ(Names(Set("\u201Ea\u201C", grade)), Names(Set("\u201Ca\u201D", grade)));
    EXPECT_EQ(Names(Set("\u201Ea\u201C \u201Cb\u201D", grade)),
              Names(Set("\u201Ca\u201D \u201Cb\u201D", grade)));
    EXPECT_EQ(Names(Set("\u201Ea \u201Ab\u2018\u201C", grade)),
              Names(Set("\u201Ca \u2018b\u2019\u201D", grade)));
    // Closed by another mark, or never: what comes behind is English again.
    EXPECT_EQ(Names(Set("\u201Ea\u201D \u201Cb", grade)),
              Names(Set("\u201Ca\u201D \u201Cb", grade)));
    EXPECT_EQ(Names(Set("\u201Ea\n\n\u201Cb", grade)), Names(Set("\u201Ca\n\n\u201Cb", grade)));
  }
}

}  // namespace
}  // namespace moontrace
