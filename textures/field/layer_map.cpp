// The map of the layers beyond the first: drawn outside the tick, may allocate.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <variant>

#include "textures/field/field_cells.h"
#include "textures/field/field_place.h"

namespace moontrace {

namespace {

constexpr double kMostSquares = 0x1p19;  // a quarter of a megabyte
constexpr double kMostDrawn = 0x1p24;    // squares that are looked at, all elements together

/// Of the strokes beyond the first layer.
double FinestWidth(const std::vector<CompiledPart>& parts) {
  double finest = HUGE_VAL;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    for (const FlatProfile& profile : parts[i].layer.profiles) {
      finest = std::min(finest, 2 * profile.half);
    }
  }
  return finest;
}

glm::dvec2 SizeOf(const Box& box) { return box.max - box.min; }

/// From one square on, up to another that is not among them.
struct Squares {
  std::uint32_t left = 0, low = 0, right = 0, high = 0;
};

/// A map while it is drawn.
struct Canvas {
  glm::dvec2 origin_P;  ///< [m]
  double side;          ///< of a square [m]
  std::uint32_t columns, rows;
  std::vector<std::uint8_t>& pairs;

  /// Those that a box of the page touches.
  Squares Touched(const Box& box_P) const {
    const auto number = [this](double from_edge, std::uint32_t count) {
      const double squares_on = from_edge / side;
      // comparisons are written so that a NaN is the first
      return squares_on > 0 ? static_cast<std::uint32_t>(std::min(squares_on, count - 1.0)) : 0;
    };
    const glm::dvec2 low = box_P.min - origin_P, high = box_P.max - origin_P;
    return {number(low.x, columns), number(low.y, rows), number(high.x, columns) + 1,
            number(high.y, rows) + 1};
  }
};

/// What is drawn: an element of a group, and how far beyond it something can matter.
struct Drawn {
  const Element& element;
  glm::dvec2 origin_P;  ///< of the group [m]
  double reach;         ///< [m]
  unsigned bit;
};

/// By halves, so that a long stroke costs no more than the squares that it goes through.
void Draw(const Drawn& drawn, const Squares& squares, Canvas& canvas) {
  const glm::dvec2 low(squares.left, squares.low), high(squares.right, squares.high);
  const glm::dvec2 middle = canvas.origin_P + 0.5 * canvas.side * (low + high) - drawn.origin_P;
  const double reach = 0.5 * canvas.side * glm::length(high - low) + drawn.reach;
  // a fill is not told from its box, since each of its edges would have to be asked
  const bool is_fill = std::holds_alternative<Fill>(drawn.element.shape);
  if (!is_fill && !CanMatter(drawn.element, middle, reach)) return;
  const std::uint32_t wide = squares.right - squares.left, tall = squares.high - squares.low;
  if (wide == 1 && tall == 1) {
    const std::uint32_t square = squares.low * canvas.columns + squares.left;
    std::uint8_t& pair = canvas.pairs[square / 2];
    pair = static_cast<std::uint8_t>(pair | drawn.bit << (4 * (square % 2)));
    return;
  }
  Squares first = squares, second = squares;
  if (wide >= tall) {
    first.right = second.left = squares.left + wide / 2;
  } else {
    first.high = second.low = squares.low + tall / 2;
  }
  Draw(drawn, first, canvas);
  Draw(drawn, second, canvas);
}

}  // namespace

LayerMap::LayerMap(const std::vector<CompiledPart>& parts) {
  Box all;
  double drawn = 0;  // the area of all elements' boxes [m^2]
  for (std::size_t i = 1; i < parts.size(); ++i) {
    for (const PlacedGroup& place : parts[i].places) {
      Include(all, place.box);
      for (const Element& element : place.group->elements) {
        const glm::dvec2 sides = glm::max(SizeOf(BoxOf(element, place)), 0.0);
        drawn += sides.x * sides.y;
      }
    }
  }
  if (all.min.x > all.max.x) return;
  const glm::dvec2 size = SizeOf(all);
  // half as wide as a stroke, unless that makes too many; nor too many along a side
  const double side =
      std::max({0.5 * FinestWidth(parts), std::sqrt(size.x) * std::sqrt(size.y / kMostSquares),
                std::max(size.x, size.y) / (0.25 * kMostSquares), std::sqrt(drawn / kMostDrawn)});
  origin_P_ = all.min;
  per_m_ = 1 / side;
  columns_ = std::floor(size.x * per_m_) + 1;
  rows_ = std::floor(size.y * per_m_) + 1;
  pairs_.assign(static_cast<std::size_t>(columns_ * rows_ / 2) + 1, 0);
  Canvas canvas{origin_P_, side, static_cast<std::uint32_t>(columns_),
                static_cast<std::uint32_t>(rows_), pairs_};
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const unsigned bit = 1u << std::min(i - 1, kBits - 1);
    for (const PlacedGroup& place : parts[i].places) {
      for (const Element& element : place.group->elements) {
        const Box box = BoxOf(element, place);
        if (!(box.min.x <= box.max.x)) continue;  // an outline without pieces
        Draw({element, place.origin, ReachIn(place), bit}, canvas.Touched(box), canvas);
      }
    }
  }
}

}  // namespace moontrace
