#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "textures/field/element.h"

namespace moontrace {

/// A colour, each part 0..1.
struct Color {
  double red = 0;
  double green = 0;
  double blue = 0;
};

/// So much of `b` [0..1] in `a`.
inline Color Mixed(const Color& a, const Color& b, double share) {
  return {a.red + share * (b.red - a.red), a.green + share * (b.green - a.green),
          a.blue + share * (b.blue - a.blue)};
}

/// Lines and arcs, joined within a subpath; filled, stroked with round caps and joins, or both.
struct PathMark {
  std::vector<std::vector<Piece>> subpaths;
  std::optional<Color> fill;
  std::optional<Color> stroke;
  double width = 0;     ///< of the stroke [mm]
  bool dashed = false;  ///< dashes of three widths
};

/// Straight from point to point, stroked.
struct TrackMark {
  std::vector<glm::dvec2> points;
  Color stroke;
  double width = 0;  ///< [mm]
  bool dashed = false;
};

struct CircleMark {
  glm::dvec2 center{0, 0};
  double radius = 0;  ///< [mm]
  std::optional<Color> fill;
  std::optional<Color> stroke;
  double width = 0;  ///< [mm]
};

/// One line of print, standing on `at`.
struct TextMark {
  glm::dvec2 at{0, 0};
  double height = 3;  ///< of a capital, about [mm]
  std::string text;   ///< UTF-8
  Color color;
};

using Mark = std::variant<PathMark, TrackMark, CircleMark, TextMark>;

/// A picture as a value: lengths in millimetres, origin at the lower left corner, y up, on white.
/// Marks are painted in order.
struct Drawing {
  double width = 0;         ///< [mm]
  double height = 0;        ///< [mm]
  std::string title;        ///< one line
  std::string description;  ///< what is to be seen, in words
  std::vector<Mark> marks;
};

/// Height that the words take as lines of at most `width`, and the marks themselves below `top`:
/// capitals of `height`, lines 1.7 heights apart. Widths are estimated, 0.75 heights a character.
std::vector<TextMark> TextBlock(std::string_view words, glm::dvec2 top_left, double width,
                                double height, Color color);

}  // namespace moontrace
