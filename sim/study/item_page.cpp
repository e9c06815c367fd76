#include "sim/study/item_page.h"

#include <algorithm>

#include "textures/relief/glyph_group.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

constexpr double kMargin = 0.010;  // [m]

/// What the strokes of all glyphs take up within their em boxes [em].
Box Reach(const Script& script) {
  Box reach;
  for (const Glyph& glyph : script.glyphs) {
    for (const Stroke& stroke : glyph.strokes) {
      for (const Piece& piece : stroke.pieces) Include(reach, BoundsOf(piece));
    }
  }
  return reach;
}

}  // namespace

ItemPage SetItem(const std::string& text, const Script& script, double size,
                 const ItemRelief& relief) {
  ItemPage item;
  TypeStyle style = DefaultStyle(size, Relief::kEngraved, script);
  style.grade = relief.grade;
  if (relief.depth_share > 0) style.depth *= relief.depth_share;
  // Room for one line, however long; text is a few letters.
  const double width = 2 * kMargin + size * 3 * static_cast<double>(text.size() + 2);
  const PageSpec spec{"custom", std::min(width, 5.0), 2 * kMargin + 2 * style.line_pitch, kMargin};
  Typeset set = SetText(text, script, style, spec);
  item.style = set.style;
  item.page = std::move(set.pages.front());
  item.strokes = IntendedStrokes(item.page, script, item.style);
  if (relief.depth_share > 0) {
    item.field = TextureField(BuildTexture(item.page, script, item.style));
  }
  item.space = script.space_advance;
  const Box reach = Reach(script);
  for (const PlacedGlyph& glyph : item.page.glyphs) {
    Include(item.box_P, Moved({size * reach.min, size * reach.max}, glyph.origin_P));
  }
  return item;
}

}  // namespace moontrace
