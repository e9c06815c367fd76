// Where the compiled field keeps its letters: on a raster or not, apart or overlapping, the tree
// itself says what is right.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/vec2.hpp>
#include <limits>
#include <random>
#include <vector>

#include "textures/field/field.h"

namespace moontrace {
namespace {

constexpr double kEm = 5e-3;  // [m]

/// A stroke and its cap, so wide [em]; a groove of 1 mm.
std::shared_ptr<const Group> Letter(double width) {
  const Profile profile{1e-3, 0.3e-3, 0.2e-3};
  Group group;
  group.elements = {{Line{{0, 0}, {width * kEm, 0.8 * kEm}}, profile}, {Dot{{0, 0}}, profile}};
  return Finish(group);
}

Texture PageOf(std::vector<Placement> placements) {
  Group page;
  page.placements = std::move(placements);
  return {{{Finish(page), Relief::kEngraved}}, {}};
}

/// Lines of letters of different widths, each `gap` [em] behind the one before; every third line is
/// short, every fifth missing.
std::vector<Placement> Lines(std::size_t lines, std::size_t length, double gap,
                             std::uint64_t seed) {
  const double widths[] = {0.1, 0.45, 0.9, 1.1};
  std::vector<std::shared_ptr<const Group>> letters;
  for (const double width : widths) letters.push_back(Letter(width));
  std::mt19937_64 random(seed);
  std::vector<Placement> placements;
  for (std::size_t line = 0; line < lines; ++line) {
    if (line % 5 == 4) continue;
    double x = 0.01;
    for (std::size_t i = 0; i < (line % 3 == 2 ? 1 : length); ++i) {
      // runs of the narrowest letter crowd, spaces between words thin out
      const std::size_t which = random() % 8 < 4 ? 0 : random() % 4;
      placements.push_back({letters[which], {x, -1.8 * kEm * static_cast<double>(line)}});
      x += kEm * (widths[which] + gap + (random() % 6 == 0 ? 1.4 : 0));
    }
  }
  return placements;
}

/// Compares field and tree in and around randomly chosen placements. Places agree to 8 units in the
/// last place of the greatest, and displacement changes by the slope times that.
void ExpectTheTree(const std::vector<Placement>& placements, int points) {
  const Texture texture = PageOf(placements);
  const TextureField field(texture);
  double extent = 0;
  for (const Placement& placement : placements) {
    extent = std::max(extent, std::abs(placement.origin.x));
  }
  const double tolerance =
      1e-17 + 8 * std::numeric_limits<double>::epsilon() * extent * field.greatest_slope();
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> around(-0.5, 1.5);
  int felt = 0;
  for (int i = 0; i < points; ++i) {
    const glm::dvec2 p = placements[random() % placements.size()].origin +
                         kEm * glm::dvec2(around(random), around(random));
    const double tree = SampleTree(texture, p).displacement;
    ASSERT_NEAR(field.SampleAt(p).displacement, tree, tolerance) << p.x << " " << p.y;
    felt += tree != 0 ? 1 : 0;
  }
  EXPECT_GT(felt, points / 40);
}

TEST(FieldRows, EvenlySetTextEqualsTheTree) {
  for (const std::size_t length : {1u, 2u, 4u, 5u, 64u}) {
    ExpectTheTree(Lines(12, length, 0.6, length), 4000);
  }
}

TEST(FieldRows, EvenlySetTextTakesAFewBytesALetter) {
  // two bytes in full lines; lines that are short or missing are stored like full ones
  const std::vector<Placement> few = Lines(5, 200, 0.6, 1), many = Lines(305, 200, 0.6, 1);
  const std::size_t more =
      TextureField(PageOf(many)).memory_bytes() - TextureField(PageOf(few)).memory_bytes();
  EXPECT_LT(more, 8 * (many.size() - few.size()));
}

/// Lines of 60 letters whose advances are whole thousandths of an em, as fonts have them.
std::vector<Placement> InThousandths(std::size_t lines, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::shared_ptr<const Group>> letters;
  std::vector<double> advances;
  for (int i = 0; i < 26; ++i) {
    advances.push_back(0.001 * static_cast<double>(450 + random() % 900));
    letters.push_back(Letter(advances.back() - 0.3));
  }
  std::vector<Placement> placements;
  for (std::size_t line = 0; line < lines; ++line) {
    double x = 0.01;
    for (int i = 0; i < 60; ++i) {
      const std::size_t which = random() % letters.size();
      placements.push_back({letters[which], {x, -1.8 * kEm * static_cast<double>(line)}});
      x += kEm * (advances[which] + (random() % 6 == 0 ? 1.4 : 0));
    }
  }
  return placements;
}

// Rounding must not decide: each step's least error adds up over a row of 70,000 steps.
TEST(FieldRows, SoDoesEveryTextInThousandthsOfAnEm) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    // so many lines that fewer bytes matter more than a little time
    const std::vector<Placement> page = InThousandths(180, seed);
    EXPECT_LT(TextureField(PageOf(page)).memory_bytes(), 24 * page.size()) << seed;
  }
}

/// Letters of two widths, each at a place of its own in a raster of cells, as in Braille.
std::vector<Placement> Cells(std::size_t lines, std::size_t length) {
  const std::shared_ptr<const Group> letters[] = {Letter(0.1), Letter(0.8)};
  std::mt19937_64 random(4);
  std::vector<Placement> placements;
  for (std::size_t line = 0; line < lines; ++line) {
    for (std::size_t i = 0; i < length; ++i) {
      if (random() % 6 == 0) continue;
      placements.push_back(
          {letters[random() % 2],
           {0.01 + 1.2 * kEm * static_cast<double>(i), -1.8 * kEm * static_cast<double>(line)}});
    }
  }
  return placements;
}

TEST(FieldRows, LettersInCellsEqualTheTreeAndTakeAFewBytes) {
  ExpectTheTree(Cells(12, 32), 4000);
  const std::vector<Placement> few = Cells(5, 100), many = Cells(305, 100);
  const std::size_t more =
      TextureField(PageOf(many)).memory_bytes() - TextureField(PageOf(few)).memory_bytes();
  EXPECT_LT(more, 8 * (many.size() - few.size()));
}

TEST(FieldRows, TextWithoutARasterEqualsTheTree) {
  std::vector<Placement> placements = Lines(12, 40, 0.6, 7);
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> shift(0, 0.1 * kEm);
  for (Placement& placement : placements) placement.origin.x += shift(random);
  ExpectTheTree(placements, 4000);
}

TEST(FieldRows, LettersAboveTheirLineEqualTheTree) {
  std::vector<Placement> placements = Lines(12, 40, 0.6, 9);
  for (std::size_t i = 0; i < placements.size(); i += 3) placements[i].origin.y += 0.2 * kEm;
  ExpectTheTree(placements, 4000);
}

TEST(FieldRows, OverlappingLettersEqualTheTree) {
  ExpectTheTree(Lines(12, 40, 0.05, 10), 4000);  // grooves are 0.2 em wide
}

TEST(FieldRows, MoreKindsOfStepsThanACodeCanNumberEqualTheTree) {
  std::vector<Placement> placements;
  const std::shared_ptr<const Group> letter = Letter(0.3);
  double x = 0;
  for (int i = 0; i < 400; ++i) {
    placements.push_back({letter, {x, 0.0}});
    x += kEm * (0.6 + 0.001 * i);  // 400 different steps
  }
  ExpectTheTree(placements, 4000);
}

// A line of 70 000 letters is longer than 16 bits can count, in letters and in steps.
TEST(FieldRows, AVeryLongLineEqualsTheTree) {
  std::vector<Placement> placements;
  const std::shared_ptr<const Group> letter = Letter(0.3);
  for (int i = 0; i < 70000; ++i) {
    placements.push_back({letter, {kEm * 0.001 * (700 * i + i % 2), 0.0}});
  }
  ExpectTheTree(placements, 40);
}

TEST(FieldRows, ACrowdBehindAWideGapEqualsTheTree) {
  // 60 narrow letters at the end of a line that is otherwise empty: no even row holds them
  std::vector<Placement> placements = {{Letter(0.1), {0.0, 0.0}}};
  for (int i = 0; i < 60; ++i) {
    placements.push_back({Letter(0.1), {kEm * (500 + 0.4 * i), 0.0}});
  }
  ExpectTheTree(placements, 4000);
}

// Two grooves that mirror each other meet at equal depths: there the first in the tree gives the
// gradient, whichever stands further left.
TEST(FieldRows, TheFirstInTheTreeDecidesATie) {
  const Profile profile{1e-3, 0.3e-3, 0.2e-3};
  Group group;
  group.elements = {{Line{{0, 0}, {0, 4e-3}}, profile}};
  const std::shared_ptr<const Group> stroke = Finish(group);
  const Placement left{stroke, {0.0, 0.0}}, right{stroke, {0.5e-3, 0.0}};
  const glm::dvec2 middle(0.25e-3, 2e-3);
  for (const auto& order : {std::vector{left, right}, std::vector{right, left}}) {
    const Texture texture = PageOf(order);
    const Sample tree = SampleTree(texture, middle),
                 sample = TextureField(texture).SampleAt(middle);
    EXPECT_NE(tree.gradient.x, 0);
    // the tree writes the profile as its pieces, the field as parabolas: a few roundings apart
    EXPECT_NEAR(sample.displacement, tree.displacement, 1e-18);
    EXPECT_NEAR(sample.gradient.x, tree.gradient.x, 1e-15);
    EXPECT_EQ(sample.gradient.y, tree.gradient.y);
  }
}

}  // namespace
}  // namespace moontrace
