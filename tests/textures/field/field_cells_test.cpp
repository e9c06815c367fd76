// What the grid behind a letter leaves out never matters: fills that rims tell, caps beside their
// strokes. The tree itself says what is right.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <random>
#include <vector>

#include "textures/base/units.h"
#include "textures/field/field.h"

namespace moontrace {
namespace {

constexpr Profile kProfile{1e-3, 0.3e-3, 0.2e-3};
/// Places of a few millimetres are exact to 1e-18 m, what is derived from them to some of those;
/// a cap may lie 1e-16 m beside the spine that stands for it.
constexpr double kRounding = 2e-16;

/// Rows of points over the letter, many at once: bit for bit what one by one gives.
void ExpectTheSameAtOnce(const TextureField& field, const Box& box) {
  std::vector<glm::dvec2> points;
  for (double y = box.min.y; y < box.max.y; y += 0.13e-3) {
    for (double x = box.min.x; x < box.max.x; x += 0.03e-3) {
      points.push_back(glm::dvec2(0.031, 0.02) + glm::dvec2(x, y));
    }
  }
  std::vector<Sample> samples(points.size());
  field.SamplesAt(points, samples);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Sample one = field.SampleAt(points[i]);
    const bool same = std::memcmp(&one, &samples[i], sizeof one) == 0;
    EXPECT_TRUE(same) << points[i].x << " " << points[i].y;
    if (!same) return;
  }
}

/// Compares field and tree all over a letter of these elements; returns how many points felt
/// something.
int ExpectTheTree(std::vector<Element> elements, Relief relief, std::uint64_t seed) {
  Group group;
  group.elements = std::move(elements);
  const std::shared_ptr<const Group> letter = Finish(group);
  Group page;
  page.placements = {{letter, {0.01, 0.02}}, {letter, {0.031, 0.02}}};
  const Texture texture{{{Finish(page), relief}}, {}};
  const TextureField field(texture);
  std::mt19937_64 random(seed);
  const Box box = Grown(letter->bounds, 0.2e-3);
  std::uniform_real_distribution<double> x(box.min.x, box.max.x), y(box.min.y, box.max.y);
  int felt = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec2 p = glm::dvec2(0.031, 0.02) + glm::dvec2(x(random), y(random));
    const Sample tree = SampleTree(texture, p), sample = field.SampleAt(p);
    const bool equal = std::abs(sample.displacement - tree.displacement) <= kRounding;
    EXPECT_TRUE(equal) << p.x << " " << p.y << ": " << sample.displacement << ", the tree "
                       << tree.displacement;
    if (!equal) return felt;
    felt += tree.displacement != 0 ? 1 : 0;
  }
  ExpectTheSameAtOnce(field, box);
  return felt;
}

Arc Between(glm::dvec2 center, double radius, double from_deg, double sweep_deg) {
  return {center, radius, from_deg * kTurn / 360, sweep_deg * kTurn / 360};
}

/// From one angle about one centre to the same two points about another: a crescent, or a lens.
Fill TwoArcs(double radius, double half_deg, double other_radius, bool bulges) {
  const double half = half_deg * kTurn / 360;
  const double chord = radius * std::sin(half), at = radius * std::cos(half);
  const double other_half = std::asin(chord / other_radius);
  const double other_at = at - (bulges ? -1 : 1) * other_radius * std::cos(other_half);
  const Arc first{{0, 0}, radius, -half, 2 * half};
  const Arc back = bulges ? Arc{{other_at, 0}, other_radius, kTurn / 2 - other_half, 2 * other_half}
                          : Arc{{other_at, 0}, other_radius, other_half, -2 * other_half};
  return {{first, back}};
}

/// A disc with a narrow slit from the right between two arcs, which bound parts of it that lie
/// beside each other, not one between them.
Fill Slit(double radius, double mouth_deg) {
  const glm::dvec2 upper = radius * DirectionOf(mouth_deg * kTurn / 360);
  const glm::dvec2 lower(upper.x, -upper.y), end(0.1 * radius, 0);
  // the arc about a point far above or below through both ends
  const auto through = [](glm::dvec2 from, glm::dvec2 to, double far) {
    const glm::dvec2 half = 0.5 * (to - from), side = glm::normalize(glm::dvec2(-half.y, half.x));
    const glm::dvec2 center = from + half + far * side;
    const double start = std::atan2(from.y - center.y, from.x - center.x);
    const double stop = std::atan2(to.y - center.y, to.x - center.x);
    return Arc{center, glm::length(from - center), start, std::remainder(stop - start, kTurn)};
  };
  const Arc around = Between({0, 0}, radius, mouth_deg, 360 - 2 * mouth_deg);
  return {{around, through(lower, end, -8e-3), through(end, upper, -8e-3)}};
}

TEST(FieldCells, FillsOfArcsEqualTheTree) {
  const Element ring{Between({0, 0}, 3.45e-3, 30, 300), kProfile};
  const Element bar{Line{{-5e-3, 0.3e-3}, {5e-3, -0.4e-3}}, kProfile};
  const std::vector<Fill> fills = {
      TwoArcs(4.03e-3, 64, 3.64e-3, false),  // the crescent of Moon's h, nearly
      TwoArcs(4e-3, 70, 6e-3, false),
      TwoArcs(4e-3, 50, 4e-3, true),
      Slit(4e-3, 5),
      Slit(3e-3, 2),
      {{Between({0.5e-3, 0}, 1.2e-3, 0, 360)}}};
  std::uint64_t seed = 0;
  for (const Fill& fill : fills) {
    for (const Relief relief : {Relief::kEngraved, Relief::kEmbossed}) {
      EXPECT_GT(ExpectTheTree({{fill, kProfile}}, relief, ++seed), 2000) << seed;
      EXPECT_GT(ExpectTheTree({ring, bar, {fill, kProfile}}, relief, ++seed), 2000) << seed;
    }
  }
}

TEST(FieldCells, FillsOfAnotherWidthEqualTheTree) {
  const Profile wide{1.6e-3, 0.4e-3, 0.3e-3};
  const Element bar{Line{{-5e-3, 0.3e-3}, {5e-3, -0.4e-3}}, kProfile};
  EXPECT_GT(
      ExpectTheTree({bar, {TwoArcs(4.03e-3, 64, 3.64e-3, false), wide}}, Relief::kEngraved, 1),
      2000);
}

TEST(FieldCells, StrokesWithCapsAndJointsEqualTheTree) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> turn(-1.5, 1.5), length(0.3e-3, 4e-3),
      radius(0.4e-3, 3e-3);
  for (std::uint64_t letter = 0; letter < 40; ++letter) {
    std::vector<Element> elements;
    glm::dvec2 at(0, 0);
    double heading = 2 * turn(random);
    elements.push_back({Dot{at}, kProfile});
    for (int piece = 0; piece < 5; ++piece) {
      if (random() % 2 == 0) {
        const glm::dvec2 to = at + length(random) * DirectionOf(heading);
        elements.push_back({Line{at, to}, kProfile});
        at = to;
      } else {
        const double r = radius(random), sweep = 2 * turn(random);
        const glm::dvec2 center = at + r * DirectionOf(heading + (sweep < 0 ? -1 : 1) * kTurn / 4);
        const double start = heading + (sweep < 0 ? 1 : -1) * kTurn / 4;
        const Arc arc{center, r, start, sweep};
        elements.push_back({arc, kProfile});
        at = EndOf(Piece(arc));
        heading += sweep;
      }
      elements.push_back({Dot{at}, kProfile});
      if (random() % 3 == 0) heading += turn(random);  // a corner, not a bend
    }
    EXPECT_GT(ExpectTheTree(elements, Relief::kEngraved, letter), 2000) << letter;
  }
}

TEST(FieldCells, LinesCappedAtOneEndOrBothEqualTheTree) {
  // from shorter than a cell to longer than the groove is wide
  std::uint64_t seed = 0;
  for (const double length : {0.02e-3, 0.2e-3, 0.6e-3, 3e-3}) {
    const Line line{{0.1e-3, -0.2e-3}, {0.1e-3 + 0.8 * length, -0.2e-3 + 0.6 * length}};
    const Element bar{line, kProfile}, first{Dot{line.from}, kProfile},
        last{Dot{line.to}, kProfile};
    const Element other{Dot{line.to + glm::dvec2(0.9e-3, 0.1e-3)}, kProfile};
    for (const Relief relief : {Relief::kEngraved, Relief::kEmbossed}) {
      EXPECT_GT(ExpectTheTree({first, bar}, relief, ++seed), 2000) << length;
      EXPECT_GT(ExpectTheTree({bar, last}, relief, ++seed), 2000) << length;
      EXPECT_GT(ExpectTheTree({first, bar, last}, relief, ++seed), 2000) << length;
      EXPECT_GT(ExpectTheTree({other, bar, last}, relief, ++seed), 2000) << length;
    }
  }
}

TEST(FieldCells, ACapOfAnotherWidthEqualsTheTree) {
  const Profile wide{1.3e-3, 0.3e-3, 0.2e-3};
  const Line line{{0, 0}, {2e-3, 0.5e-3}};
  const Element bar{line, kProfile}, cap{Dot{line.to}, wide}, own{Dot{line.to}, kProfile};
  EXPECT_GT(ExpectTheTree({bar, cap}, Relief::kEngraved, 1), 2000);
  EXPECT_GT(ExpectTheTree({own, bar, cap}, Relief::kEmbossed, 2), 2000);
}

TEST(FieldCells, AHairInAGroupOfAKilometreEqualsTheTree) {
  const Profile hair{1e-6, 0.3e-6, 0.2e-6};
  Group group;
  group.elements = {{Line{{0, 0}, {1000, 0}}, hair}, {Line{{500, -3e-6}, {500, 3e-6}}, hair}};
  const Texture texture{{{Finish(group), Relief::kEngraved}}, {}};
  const TextureField field(texture);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> x(499.999, 500.001), y(-1e-6, 1e-6);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec2 p(x(random), y(random));
    // places are exact to 1e-13 m there
    ASSERT_NEAR(field.SampleAt(p).displacement, SampleTree(texture, p).displacement, 1e-12);
  }
  EXPECT_LT(field.SampleAt({999.0, 0.0}).displacement, -0.2e-6);
}

TEST(FieldCells, FlatPaperInALetterIsPlusZeroOneByOneAndAtOnce) {
  Group group;
  group.elements = {{Line{{0, 0}, {4e-3, 4e-3}}, kProfile}};
  Group page;
  const std::shared_ptr<const Group> letter = Finish(group);
  page.placements = {{letter, {0, 0}}, {letter, {0.02, 0}}};
  const TextureField field({{{Finish(page), Relief::kEngraved}}, {}});
  std::vector<glm::dvec2> points;
  for (int i = 0; i <= 80; ++i) points.emplace_back(0.05e-3 * i, 1e-3);
  std::vector<Sample> samples(points.size());
  field.SamplesAt(points, samples);
  int flat = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Sample one = field.SampleAt(points[i]);
    EXPECT_EQ(one.displacement, samples[i].displacement);
    if (one.displacement != 0) continue;
    ++flat;
    for (const Sample& sample : {one, samples[i]}) {
      EXPECT_FALSE(std::signbit(sample.displacement)) << i;
      EXPECT_FALSE(std::signbit(sample.gradient.x)) << i;
      EXPECT_FALSE(std::signbit(sample.gradient.y)) << i;
    }
  }
  EXPECT_GT(flat, 30);
}

}  // namespace
}  // namespace moontrace
