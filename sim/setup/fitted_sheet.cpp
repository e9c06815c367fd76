#include "sim/setup/fitted_sheet.h"

#include <algorithm>
#include <glm/vec2.hpp>
#include <optional>

namespace moontrace {

namespace {

/// Where the letters of a page lie; none: the text is no short one.
std::optional<Box> ShortText(const Typeset& set, const Script& script) {
  if (set.pages.size() != 1 || set.pages.front().glyphs.empty()) return std::nullopt;
  Box text;
  for (const PlacedGlyph& placed : set.pages.front().glyphs) {
    const double em = ScaleOf(placed.kind, set.style) * set.style.size;
    Include(text, placed.origin_P);
    Include(text, placed.origin_P + em * glm::dvec2(script.glyphs.at(placed.glyph).advance, 1));
  }
  if (text.max.y - text.min.y + 2 * set.page.margin > set.page.width) return std::nullopt;
  return text;
}

void MoveTo(TextPage& page, const Box& text, glm::dvec2 sheet) {
  const glm::dvec2 shift = 0.5 * (sheet - text.min - text.max);
  for (PlacedGlyph& placed : page.glyphs) placed.origin_P += shift;
}

}  // namespace

void FitSheet(Typeset& set, const Script& script) {
  const std::optional<Box> text = ShortText(set, script);
  if (!text) return;
  TextPage& page = set.pages.front();
  const glm::dvec2 size = text->max - text->min;
  const double side = std::max(size.x, size.y) + 2 * set.page.margin;
  MoveTo(page, *text, {side, side});
  set.page.name = "custom";
  set.page.width = set.page.height = side;
  page.sheet_P = {{0, 0}, {side, side}};
  page.text_area_P = Grown(page.sheet_P, -set.page.margin);
}

void CentreText(Typeset& set, const Script& script) {
  const std::optional<Box> text = ShortText(set, script);
  if (text) MoveTo(set.pages.front(), *text, {set.page.width, set.page.height});
}

}  // namespace moontrace
