#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/textures/small_script.h"
#include "textures/base/error.h"
#include "textures/field/profile.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Moon's stroke width.
Script WithMoonWidth() {
  Script script = SmallScript();
  script.stroke_width = 0.1165;
  return script;
}
TypeStyle Engraved(double size) { return DefaultStyle(size, Relief::kEngraved, WithMoonWidth()); }

std::string ErrorOf(const TypeStyle& style) {
  try {
    CheckStyle(style, WithMoonWidth());
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

// Design, section 3. Tolerances: rounding of a few products.
TEST(DefaultStyle, FollowsTheDesignForLargeLetters) {
  for (const double size : {0.008, 0.012, 0.040}) {
    const TypeStyle style = Engraved(size);
    const double w = 0.1165 * size;
    EXPECT_NEAR(style.width, w, 1e-15);
    EXPECT_NEAR(style.depth, w / 2, 1e-15);
    EXPECT_NEAR(style.rounding, 0.2 * w, 1e-15);
    EXPECT_EQ(style.blend_radius, 0);
    EXPECT_NEAR(style.line_pitch, 1.8 * size, 1e-15);
    EXPECT_EQ(style.letter_gap, 0);
    EXPECT_EQ(style.word_gap, 0);
  }
}

TEST(DefaultStyle, WidensTheGrooveOfSmallLetters) {
  for (const double size : {0.006, 0.004}) {
    const TypeStyle style = Engraved(size);
    EXPECT_NEAR(style.width, 0.2 * size, 1e-15);
    EXPECT_NEAR(style.depth, 0.2 * size / 3, 1e-15);
    EXPECT_NEAR(style.rounding, 0.04 * size, 1e-15);
  }
  // Half way: w = (0.1165 + 0.2)/2 em, D = (1/2 + 1/3)/2 w.
  const TypeStyle between = Engraved(0.007);
  EXPECT_NEAR(between.width, 0.15825 * 0.007, 1e-15);
  EXPECT_NEAR(between.depth, between.width * 5 / 12, 1e-15);
}

TEST(DefaultStyle, IsFlatterAndBlendedWhenEmbossed) {
  for (const double size : {0.006, 0.012}) {
    const TypeStyle style = DefaultStyle(size, Relief::kEmbossed, WithMoonWidth());
    EXPECT_EQ(style.width, Engraved(size).width);
    EXPECT_EQ(style.depth, style.width / 4);
    EXPECT_GT(style.blend_radius, 0);
  }
}

TEST(DefaultStyle, PassesItsOwnChecksAndTheProfiles) {
  for (double size = 0.001; size < 0.1; size *= 1.1) {
    for (const Relief relief : {Relief::kEngraved, Relief::kEmbossed}) {
      const TypeStyle style = DefaultStyle(size, relief, WithMoonWidth());
      EXPECT_NO_THROW(CheckStyle(style, WithMoonWidth())) << size;
      EXPECT_NO_THROW(Check(Profile{style.width, style.depth, style.rounding})) << size;
    }
  }
}

TEST(CheckStyle, RefusesLengthsThatAreNotPositiveAndFinite) {
  for (double TypeStyle::*length : {&TypeStyle::size, &TypeStyle::width, &TypeStyle::depth,
                                    &TypeStyle::rounding, &TypeStyle::line_pitch}) {
    for (const double bad : {0.0, -0.001, kNan, kInfinity, -kInfinity}) {
      TypeStyle style = Engraved(0.012);
      style.*length = bad;
      EXPECT_NE(ErrorOf(style).find("give a number above zero"), std::string::npos) << bad;
    }
  }
  for (double TypeStyle::*length :
       {&TypeStyle::blend_radius, &TypeStyle::letter_gap, &TypeStyle::word_gap}) {
    for (const double bad : {-1.0, kNan, kInfinity, -kInfinity}) {
      TypeStyle style = Engraved(0.012);
      style.*length = bad;
      EXPECT_NE(ErrorOf(style), "") << bad;
    }
  }
}

TEST(CheckStyle, RefusesLettersTooSmallToFeel) {
  EXPECT_EQ(ErrorOf(Engraved(0.001)), "");
  EXPECT_EQ(ErrorOf(Engraved(0.0009)), "letter size 0.9 mm is too small to feel: at least 1 mm");
}

TEST(CheckStyle, RefusesAGrooveWiderThanALetterCanHold) {
  TypeStyle style = Engraved(0.010);
  style.width = 0.005;
  EXPECT_EQ(ErrorOf(style), "");
  style.width = 0.006;
  EXPECT_EQ(ErrorOf(style),
            "groove width 6 mm is wider than a letter of 10 mm can hold: at most 5 mm");
}

TEST(CheckStyle, RefusesARoundingAboveAQuarterOfTheWidth) {
  TypeStyle style = Engraved(0.010);
  style.width = 0.0012;
  style.rounding = 0.0003;
  EXPECT_EQ(ErrorOf(style), "");
  style.rounding = 0.00031;
  EXPECT_EQ(ErrorOf(style),
            "rounding 0.31 mm is above a quarter of the groove width 1.2 mm: at most 0.3 mm");
}

TEST(CheckStyle, RefusesAFlankTooSteepToLeave) {
  TypeStyle style = Engraved(0.010);
  style.width = 0.0012;
  style.rounding = 0.0002;
  style.depth = 0.00199;  // slope 4.975
  EXPECT_EQ(ErrorOf(style), "");
  style.depth = 0.0021;
  EXPECT_EQ(ErrorOf(style), "groove depth 2.1 mm is too steep for the width 1.2 mm: at most 2 mm");
}

TEST(CheckStyle, RefusesGapsThatTurnTheLineBack) {
  TypeStyle style = Engraved(0.010);  // every advance and the space are 10 mm
  style.letter_gap = -0.009;
  style.word_gap = -0.009;
  EXPECT_EQ(ErrorOf(style), "");
  style.letter_gap = -0.010;
  EXPECT_EQ(ErrorOf(style),
            "letter gap -10 mm: letters would run backwards, give more than -10 mm");
  style.letter_gap = 0;
  style.word_gap = -0.011;
  EXPECT_EQ(ErrorOf(style), "word gap -11 mm: words would run backwards, give more than -10 mm");
}

TEST(CheckStyle, RefusesLinesThatRunIntoEachOther) {
  TypeStyle style = Engraved(0.010);
  style.line_pitch = 0.011;
  EXPECT_EQ(ErrorOf(style), "line pitch 11 mm: lines would run into each other, at least 11.16 mm");
}

}  // namespace
}  // namespace moontrace
