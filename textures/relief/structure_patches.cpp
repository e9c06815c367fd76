#include "textures/relief/structure_patches.h"

#include <algorithm>

#include "textures/base/units.h"

namespace moontrace {
namespace {

// Waves along the line for headings, across it for quotations, a grid for links: three textures
// that fingers can distinguish. Amplitudes of 20 um stay far below the strokes' depth.
PaperTexture TextureOf(LineKind kind, bool link, double size) {
  PaperTexture texture;
  texture.amplitude = 20e-6;
  texture.wavelength = size / 6;
  texture.kind = link ? PaperKind::kGrid : PaperKind::kSine;
  constexpr double kQuarterTurn = kTurn / 4;
  texture.angle = !link && kind == LineKind::kQuotation ? kQuarterTurn : 0;
  return texture;
}

// The glyph's own box, of its strokes along x and from foot to top along y.
Box BoxOf(const PlacedGlyph& placed, const Script& script, const TypeStyle& style) {
  const double size = ScaleOf(placed.kind, style) * style.size;
  Box box{{0, 0}, {0, size}};
  for (const Stroke& stroke : script.glyphs.at(placed.glyph).strokes) {
    for (const Piece& piece : stroke.pieces) Include(box, BoundsOf(Placed(piece, size, {0, 0})));
  }
  return Moved(box, placed.origin_P);
}

// One patch for the signs [first, last) of a row.
void AddPatch(const TextPage& page, std::size_t first, std::size_t last, bool link,
              const Script& script, const TypeStyle& style, std::vector<PaperPatch>& patches) {
  const LineKind kind = page.glyphs[first].kind;
  const double scale = ScaleOf(kind, style);
  Box box;
  for (std::size_t i = first; i < last; ++i) Include(box, BoxOf(page.glyphs[i], script, style));
  PaperPatch patch;
  // A quarter of the gap on each side leaves paper between the patches of two lines.
  const double room = scale * (style.line_pitch - style.size) / 4;
  patch.box_P = Grown(box, room);
  patch.texture = TextureOf(kind, link, scale * style.size);
  patch.fade = room;
  patches.push_back(patch);
}

}  // namespace

std::vector<PaperPatch> StructurePatches(const TextPage& page, const Script& script,
                                         const TypeStyle& style) {
  std::vector<PaperPatch> patches;
  if (!style.structure.read || !style.structure.texture) return patches;
  const std::vector<PlacedGlyph>& glyphs = page.glyphs;
  const auto add_runs = [&](auto belongs, auto same, bool link) {
    for (std::size_t first = 0; first < glyphs.size();) {
      std::size_t last = first + 1;
      if (belongs(glyphs[first])) {
        while (last < glyphs.size() && same(glyphs[first], glyphs[last])) ++last;
        AddPatch(page, first, last, link, script, style, patches);
      }
      first = last;
    }
  };
  const auto has_mark = [](const PlacedGlyph& a) {
    return a.kind == LineKind::kHeading || a.kind == LineKind::kQuotation;
  };
  add_runs(
      has_mark, [](const PlacedGlyph& a, const PlacedGlyph& b) { return a.line == b.line; }, false);
  add_runs([](const PlacedGlyph& a) { return a.link; },
           [](const PlacedGlyph& a, const PlacedGlyph& b) { return b.link && a.line == b.line; },
           true);
  return patches;
}

void AddStructurePatches(const TextPage& page, const Script& script, const TypeStyle& style,
                         Texture& texture) {
  for (PaperPatch& patch : StructurePatches(page, script, style)) {
    texture.paper.push_back(std::move(patch));
  }
}

}  // namespace moontrace
