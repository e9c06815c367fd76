#include "sim/reader/sign_belief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "textures/base/units.h"
#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

constexpr double kSize = 0.012, kWidth = 0.0014;

class SignBelief : public testing::Test {
 protected:
  SignBelief() : script_(FindScript("moon")), shapes_(script_, WrittenGlyphs(script_)) {}

  /// Points along pieces, as a tip that followed them felt them.
  static SignEvidence Along(const std::vector<Piece>& pieces, const SignPlace& place) {
    SignEvidence felt;
    felt.width = kWidth;
    for (const Piece& piece : pieces) {
      const double length = Length(piece);
      const int count = static_cast<int>(std::ceil(length / 0.05));
      for (int i = 0; i <= count; ++i) {
        felt.grooves.push_back({FromEm(place, PointAt(piece, length * i / count)), 0.5});
      }
    }
    return felt;
  }
  SignEvidence AlongGlyph(const char* name, const SignPlace& place) const {
    return Along(script_.glyphs[script_.Find(name)].strokes.front().pieces, place);
  }
  std::string NameOf(const SignGuess& guess) const {
    return guess.sign == SignGuess::kUnknown ? "unknown"
                                             : script_.glyphs[shapes_.GlyphOf(guess.sign)].name;
  }
  static PlacePrior Anywhere() {
    PlacePrior prior;
    prior.sizes = {kSize};
    prior.turns = {0};
    return prior;
  }

  Script script_;
  SignShapes shapes_;
};

TEST_F(SignBelief, PlaceInEmAndBackIsTheSame) {
  const SignPlace place{{0.03, -0.01}, kSize, 0.05};
  const glm::dvec2 p{0.7, 0.2};
  EXPECT_LT(glm::distance(ToEm(place, FromEm(place, p)), p), 1e-12);
  // one em along the line, which is turned by 0.05 rad
  const glm::dvec2 end = FromEm(place, {1, 0});
  EXPECT_NEAR(end.x, 0.03 + kSize * std::cos(0.05), 1e-15);
  EXPECT_NEAR(end.y, -0.01 + kSize * std::sin(0.05), 1e-15);
}

// The table has cells of 0.02 em: a distance, which changes no faster than its point, is off by
// half a diagonal at most.
TEST_F(SignBelief, DistancesAreThoseToTheStrokes) {
  for (std::size_t sign = 0; sign < shapes_.size(); ++sign) {
    const Glyph& glyph = script_.glyphs[shapes_.GlyphOf(sign)];
    if (glyph.strokes.size() != 1 || glyph.strokes.front().kind != StrokeKind::kStroke) continue;
    for (double x = -0.3; x < 1.3; x += 0.07) {
      for (double y = -0.3; y < 1.3; y += 0.07) {
        double nearest = SignShapes::kFarthest;
        for (const Piece& piece : glyph.strokes.front().pieces) {
          nearest = std::min(nearest, DistanceTo(piece, {x, y}));
        }
        EXPECT_NEAR(shapes_.Distance(sign, {x, y}), nearest, 0.0142) << glyph.name;
      }
    }
  }
}

// Each sign's own strokes, felt whole: nothing else fits, but what has them as a part of itself.
TEST_F(SignBelief, KnowsLettersByTheirStrokesAndWhereTheyLie) {
  const SignPlace place{{0.05, 0.02}, kSize, 0};
  for (const char* name : {"a", "c", "e", "g", "k", "l", "n", "o", "p", "u", "v", "x", "z"}) {
    const std::vector<SignGuess> belief = Believe(shapes_, AlongGlyph(name, place), Anywhere());
    const SignGuess& best = belief.front();
    // C and U are parts of CH and WH, whose dot was not looked for
    EXPECT_TRUE(NameOf(best) == name || (NameOf(best) == "ch" && *name == 'c')) << name;
    // places are tried 0.02 em apart
    EXPECT_LT(glm::distance(best.place.origin, place.origin), 0.03 * kSize) << name;
  }
}

TEST_F(SignBelief, FlatPaperSpeaksAgainstAStroke) {
  const SignPlace place{{0, 0}, kSize, 0};
  SignEvidence felt = AlongGlyph("c", place);
  const auto share = [&](const std::vector<SignGuess>& belief, const char* name) {
    for (const SignGuess& guess : belief) {
      if (NameOf(guess) == name) return guess.probability;
    }
    return 0.0;
  };
  EXPECT_GT(share(Believe(shapes_, felt, Anywhere()), "ch"), 0.3);
  // where CH has its dot
  for (double x = 0.8; x <= 1.0; x += 0.05) felt.flats.push_back({FromEm(place, {x, 0.5}), 1});
  const std::vector<SignGuess> belief = Believe(shapes_, felt, Anywhere());
  EXPECT_LT(share(belief, "ch"), 0.01);
  EXPECT_GT(share(belief, "c"), 0.98);
}

/// Sizes 4 percent apart, from half of kSize to twice.
PlacePrior OfAnySize() {
  PlacePrior prior;
  for (double size = 0.5 * kSize; size < 2 * kSize; size *= 1.04) prior.sizes.push_back(size);
  prior.turns = {0};
  return prior;
}

// An upright felt to its ends is part of a longer one, but there it would have gone on.
TEST_F(SignBelief, WhatWasFeltToItsEndsIsNoPartOfALargerSign) {
  const SignPlace place{{0, 0}, kSize, 0};
  const auto log = [&](const char* name, double size, bool whole) {
    PlacePrior prior = Anywhere();
    prior.sizes = {size};
    prior.whole = whole;
    for (const SignGuess& guess : Believe(shapes_, AlongGlyph(name, place), prior)) {
      if (NameOf(guess) == name) return guess.log_likelihood;
    }
    return -HUGE_VAL;
  };
  EXPECT_LT(log("i", 1.3 * kSize, true), log("i", 1.3 * kSize, false) - 1);
  EXPECT_LT(log("i", 1.6 * kSize, true), log("i", 1.3 * kSize, true) - 1);
  for (const char* name : {"i", "l", "o", "z"}) {
    EXPECT_EQ(log(name, kSize, true), log(name, kSize, false)) << name;
  }
}

// A ring is one at any size, to O or H it belongs; a zigzag has its bars as far apart as the letter
// is high. What is no sign speaks for no size.
TEST_F(SignBelief, SignsTellOfTheSizeTogether) {
  const PlacePrior prior = OfAnySize();
  const auto at_true = [&](const std::vector<double>& logs) {
    double near = -INFINITY;
    for (std::size_t i = 0; i < logs.size(); ++i) {
      if (std::abs(std::log(prior.sizes[i] / kSize)) < 0.05) near = std::max(near, logs[i]);
    }
    return near;
  };
  std::vector<double> sum(prior.sizes.size(), 0);
  for (const char* name : {"r", "p", "p", "o", "g"}) {
    const std::vector<double> logs = SizeLogs(shapes_, AlongGlyph(name, {{0, 0}, kSize, 0}), prior);
    ASSERT_EQ(logs.size(), sum.size());
    EXPECT_GT(at_true(logs), -2) << name;  // each alone leaves it open
    for (std::size_t i = 0; i < sum.size(); ++i) {
      EXPECT_LE(logs[i], 1e-12);
      EXPECT_GE(logs[i], std::log(0.02) - 1e-12);
      sum[i] += logs[i];
    }
  }
  const auto best = std::max_element(sum.begin(), sum.end()) - sum.begin();
  EXPECT_NEAR(std::log(prior.sizes[static_cast<std::size_t>(best)] / kSize), 0, 0.07);
  EXPECT_EQ(SizeLogs(shapes_, {}, prior), std::vector<double>(prior.sizes.size(), 0));
}

TEST_F(SignBelief, ALikelierSizeDecidesWhatCouldBeEither) {
  // a ring of O's size is an H of larger letters
  const SignEvidence felt = AlongGlyph("o", {{0, 0}, kSize, 0});
  PlacePrior prior = OfAnySize();
  const auto size_of_best = [&] { return Believe(shapes_, felt, prior).front().place.size; };
  for (const double size : prior.sizes) {
    prior.size_logs.push_back(std::abs(std::log(size / kSize)) < 0.05 ? 0 : std::log(1e-4));
  }
  EXPECT_NEAR(std::log(size_of_best() / kSize), 0, 0.05);
}

/// A tip in a dot, and on flat paper all round it.
SignEvidence DotFelt(const SignPlace& place, glm::dvec2 middle) {
  SignEvidence felt;
  felt.width = kWidth;
  for (double x = -0.04; x < 0.05; x += 0.02) {
    felt.grooves.push_back({FromEm(place, middle + glm::dvec2(x, 0.5 * x)), 0.5});
  }
  for (double turn = 0; turn < 6.2; turn += 0.17) {
    const glm::dvec2 off = 0.2 * glm::dvec2(std::cos(turn), std::sin(turn));
    felt.flats.push_back({FromEm(place, middle + off), 1});
  }
  return felt;
}

PlacePrior Expecting(const SignPlace& place) {
  PlacePrior prior;
  prior.origins = {place.origin};
  prior.along = 0.08;
  prior.across = 0.04;
  prior.sizes = {place.size};
  prior.turns = {place.turn};
  return prior;
}

// Dots have a radius of 0.11 em; the tip's middle keeps half a groove from their rim. A table's
// cell is 0.02 em.
TEST_F(SignBelief, AnywhereOnADotsFloorIsNoDistance) {
  std::size_t comma = 0;
  while (script_.glyphs[shapes_.GlyphOf(comma)].name != "comma") ++comma;
  const glm::dvec2 middle{0.05, 0.1};
  EXPECT_EQ(shapes_.Distance(comma, middle), 0);
  EXPECT_EQ(shapes_.Distance(comma, middle + glm::dvec2(0, 0.03)), 0);
  EXPECT_NEAR(shapes_.Distance(comma, middle + glm::dvec2(0.21, 0)), 0.21 - 0.11 + 0.058, 0.0142);
  EXPECT_TRUE(shapes_.IsDots(comma));
}

// Flat paper all round a short groove: no line leads on from it.
TEST_F(SignBelief, ADotIsNoPartOfALine) {
  const SignPlace place{{0.05, 0.02}, kSize, 0};
  SignEvidence felt = DotFelt(place, {0.05, 0.1});
  const auto dots = [&](const std::vector<SignGuess>& belief) {
    double sum = 0;
    for (const SignGuess& guess : belief) {
      const std::string name = NameOf(guess);
      if (name == "exclamation" || name == "unknown") continue;  // has a dot there as well
      sum += shapes_.IsDots(guess.sign) ? guess.probability : -guess.probability;
    }
    return sum;
  };
  EXPECT_GT(dots(Believe(shapes_, felt, Expecting(place))), 0.5);
  felt.flats.clear();
  EXPECT_LT(dots(Believe(shapes_, felt, Expecting(place))), 0.5);
}

// Two commas side by side, and a full stop: a dot's way and the step to the next sign differ.
TEST_F(SignBelief, AGrooveThatWasCrossedMayBeTheNextSigns) {
  const SignPlace place{{0.05, 0.02}, kSize, 0};
  const auto best = [&](double x) {
    SignEvidence felt = DotFelt(place, {0.05, 0.1});
    felt.grooves.push_back({FromEm(place, {x, 0.1}), 2, true});
    // what else has a dot there has others above
    for (double y = 0.3; y < 1; y += 0.02) {
      for (const double at : {0.05, 0.25, 0.45}) {
        felt.flats.push_back({FromEm(place, {at, y}), 1});
      }
    }
    return NameOf(Believe(shapes_, felt, Expecting(place)).front());
  };
  EXPECT_EQ(best(0.65), "full-stop");
  EXPECT_EQ(best(0.77 + 0.05), "comma");
}

// The same beside a letter: right of an I's advance stands another sign's groove; it is no reason
// to take the I for a sign that is as wide.
TEST_F(SignBelief, AnUprightBesideAnIIsTheNextSign) {
  const SignPlace place{{0, 0}, kSize, 0};
  SignEvidence felt;
  felt.width = kWidth;
  for (double y = 0; y < 1; y += 0.05) felt.grooves.push_back({FromEm(place, {0, y}), 0.5});
  const auto likelihood = [&] {
    for (const SignGuess& guess : Believe(shapes_, felt, Expecting(place))) {
      if (NameOf(guess) == "i") return guess.log_likelihood;
    }
    return -1e9;
  };
  const double alone = likelihood();
  felt.grooves.push_back({FromEm(place, {0.75, 0.4}), 2, true});
  EXPECT_GT(likelihood(), alone - 2);
  felt.grooves.back().p = FromEm(place, {0.5, 0.4});
  EXPECT_LT(likelihood(), alone - 5);
}

// What is felt 0.08 em beside a line speaks against it, unless the hand errs by as much.
TEST_F(SignBelief, AnUnsureHandForgivesMore) {
  const SignPlace place{{0, 0}, kSize, 0};
  SignEvidence felt;
  felt.width = kWidth;
  for (double y = 0; y < 1; y += 0.05) felt.grooves.push_back({FromEm(place, {0.08, y}), 0.5});
  const auto likelihood = [&] {
    PlacePrior prior = Expecting(place);
    prior.along = prior.across = 1e-3;
    for (const SignGuess& guess : Believe(shapes_, felt, prior)) {
      if (NameOf(guess) == "i") return guess.log_likelihood;
    }
    return -1e9;
  };
  const double sure = likelihood();
  felt.unsure = 0.08 * kSize;
  EXPECT_GT(likelihood(), 0.5 * sure);
}

TEST_F(SignBelief, ForeignSignsAreUnknown) {
  const SignPlace place{{0, 0}, kSize, 0};
  // a triangle, a print H, a square, none of them a part of a sign of Moon
  const std::vector<std::vector<Piece>> foreign = {
      {Line{{0, 0}, {1, 0}}, Line{{1, 0}, {0.5, 1}}, Line{{0.5, 1}, {0, 0}}},
      {Line{{0, 0}, {0, 1}}, Line{{0, 0.5}, {1, 0.5}}, Line{{1, 0}, {1, 1}}},
      {Line{{0, 0}, {0, 1}}, Line{{0, 1}, {1, 1}}, Line{{1, 1}, {1, 0}}, Line{{1, 0}, {0, 0}}}};
  for (std::size_t i = 0; i < foreign.size(); ++i) {
    const SignGuess best = Believe(shapes_, Along(foreign[i], place), Anywhere()).front();
    EXPECT_EQ(NameOf(best), "unknown") << i;
    EXPECT_GT(best.probability, 0.9) << i;
  }
}

TEST_F(SignBelief, ProbabilitiesAddUpToOne) {
  const std::vector<SignGuess> belief =
      Believe(shapes_, AlongGlyph("i", {{0, 0}, kSize, 0}), Anywhere());
  double sum = 0;
  for (const SignGuess& guess : belief) sum += guess.probability;
  EXPECT_NEAR(sum, 1, 1e-12);
  EXPECT_TRUE(Believe(shapes_, {}, Anywhere()).empty());
}

}  // namespace
}  // namespace moontrace
