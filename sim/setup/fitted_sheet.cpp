#include "sim/setup/fitted_sheet.h"

#include <algorithm>
#include <glm/vec2.hpp>

namespace moontrace {

void FitSheet(Typeset& set, const Script& script) {
  if (set.pages.size() != 1 || set.pages.front().glyphs.empty()) return;
  TextPage& page = set.pages.front();
  Box text;
  for (const PlacedGlyph& placed : page.glyphs) {
    const double em = ScaleOf(placed.kind, set.style) * set.style.size;
    Include(text, placed.origin_P);
    Include(text, placed.origin_P + em * glm::dvec2(script.glyphs.at(placed.glyph).advance, 1));
  }
  const glm::dvec2 size = text.max - text.min;
  const double side = std::max(size.x, size.y) + 2 * set.page.margin;
  if (size.y + 2 * set.page.margin > set.page.width) return;
  const glm::dvec2 shift = 0.5 * (glm::dvec2(side, side) - text.min - text.max);
  for (PlacedGlyph& placed : page.glyphs) placed.origin_P += shift;
  set.page.name = "custom";
  set.page.width = set.page.height = side;
  page.sheet_P = {{0, 0}, {side, side}};
  page.text_area_P = Grown(page.sheet_P, -set.page.margin);
}

}  // namespace moontrace
