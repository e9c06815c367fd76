#include "textures/typeset/left_out.h"

#include <gtest/gtest.h>

#include "textures/fonts/script_library.h"
#include "textures/typeset/taught.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

/// The text as it is set: each mark as "_", words apart by blanks.
std::string SetAs(const std::string& text, const std::string& taught, LeftOutWords* counts) {
  const Script script = FindScript("moon");
  TypeStyle style = DefaultStyle(0.012, Relief::kEngraved, script);
  style.only = TaughtSigns(taught, script);
  const Typeset set = SetText(text, script, style, FindPage("a4"));
  std::string read;
  const PlacedGlyph* before = nullptr;
  for (const TextPage& page : set.pages) {
    CountLeftOut(page, script, *counts);
    for (const PlacedGlyph& glyph : page.glyphs) {
      if (before != nullptr && before->word != glyph.word) read += ' ';
      const std::string& name = script.glyphs[glyph.glyph].name;
      read += name == kLeftOutMark ? "_" : name.size() == 1 ? name : "(" + name + ")";
      before = &glyph;
    }
  }
  return read;
}

TEST(LeftOutWords, HaveOneMarkEachAndNoFragmentIsLeftOfThem) {
  LeftOutWords counts;
  EXPECT_EQ(SetAs("The sun: it has a lot, made to burn.", "itlo+double-bar", &counts),
            "_ _ it _ _ lot _ to _");
  EXPECT_EQ(counts.words, 9U);
  EXPECT_EQ(counts.left_out, 6U);
}

TEST(LeftOutWords, AreThoseOfWhichAMarkBetweenLettersOrADigitIsNotTaught) {
  LeftOutWords counts;
  EXPECT_EQ(SetAs("we'll \"we\" ill, 12 well-lit", "weli+full-stop+double-bar", &counts),
            "_ we ill _ _");
  EXPECT_EQ(SetAs("we'll. (sun.)", "wel+apostrophe+full-stop+double-bar", &counts),
            "we(apostrophe)ll(full-stop) _(full-stop)");
}

TEST(LeftOutWords, AreSpeltWithoutContractionsThatAreNotTaught) {
  LeftOutWords counts;
  EXPECT_EQ(SetAs("the hen thin", "then+double-bar", &counts), "the hen _");
  EXPECT_EQ(SetAs("the hen then", "hen+th+double-bar", &counts), "(th) hen (th)en");
}

TEST(LeftOutWords, StayFragmentsWhereTheMarkIsNotTaught) {
  LeftOutWords counts;
  EXPECT_EQ(SetAs("sun it", "itu", &counts), "u it");
  EXPECT_EQ(counts.left_out, 0U);
}

}  // namespace
}  // namespace moontrace
