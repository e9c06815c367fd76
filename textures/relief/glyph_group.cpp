#include "textures/relief/glyph_group.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <map>
#include <memory>
#include <utility>

#include "textures/base/overload.h"
#include "textures/relief/groove_links.h"
#include "textures/relief/structure_patches.h"
#include "textures/typeset/rules.h"
#include "textures/typeset/sheet_texture.h"

namespace moontrace {
namespace {

// Ends that lie this close are one point; coordinates come from sines, so they are never equal.
constexpr double kSamePoint = 1e-6;  // [em]

bool IsFullCircle(const Piece& piece) {
  return std::visit(Overload{[](const Line&) { return false; },
                             [](const Arc& arc) {
                               return std::abs(arc.sweep) >= glm::two_pi<double>() * (1 - 1e-12);
                             }},
                    piece);
}

void AddPoint(std::vector<glm::dvec2>& points, glm::dvec2 p) {
  for (const glm::dvec2& other : points) {
    if (glm::distance(other, p) < kSamePoint) return;
  }
  points.push_back(p);
}

// Ends and joints of all strokes, each once [em].
std::vector<glm::dvec2> Points(const Glyph& glyph) {
  std::vector<glm::dvec2> points;
  for (const Stroke& stroke : glyph.strokes) {
    if (stroke.kind != StrokeKind::kStroke) continue;
    for (const Piece& piece : stroke.pieces) {
      if (IsFullCircle(piece)) continue;
      AddPoint(points, StartOf(piece));
      AddPoint(points, EndOf(piece));
    }
  }
  return points;
}

Fill ScaledFill(const Stroke& stroke, double size) {
  Fill fill;
  for (const Piece& piece : stroke.pieces) fill.outline.push_back(Placed(piece, size, {0, 0}));
  return fill;
}

// A disc; at least as wide as the groove, since a fill is at full depth w/2 inside its outline.
Fill Disc(const Stroke& dot, const TypeStyle& style) {
  Fill fill = ScaledFill(dot, style.size);
  for (Piece& piece : fill.outline) {
    std::visit(Overload{[](Line&) {},
                        [&style](Arc& arc) { arc.radius = std::max(arc.radius, style.width / 2); }},
               piece);
  }
  return fill;
}

}  // namespace

Group BuildGlyph(const Glyph& glyph, const TypeStyle& style) {
  const Profile profile{style.width, style.depth, style.rounding};
  Group group;
  group.blend_radius = style.blend_radius;
  for (const Stroke& stroke : glyph.strokes) {
    if (stroke.kind != StrokeKind::kStroke) continue;
    for (const Piece& piece : stroke.pieces) {
      const Piece placed = Placed(piece, style.size, {0, 0});
      std::visit([&](const auto& shape) { group.elements.push_back({shape, profile}); }, placed);
    }
  }
  for (const glm::dvec2& point : Points(glyph)) {
    group.elements.push_back({Dot{point * style.size}, profile});
  }
  for (const Stroke& stroke : glyph.strokes) {
    switch (stroke.kind) {
      case StrokeKind::kStroke:
        break;  // above
      case StrokeKind::kDot:
        group.elements.push_back({Disc(stroke, style), profile});
        break;
      case StrokeKind::kFill:
        group.elements.push_back({ScaledFill(stroke, style.size), profile});
        break;
    }
  }
  return group;
}

Texture BuildTexture(const TextPage& page, const Script& script, const TypeStyle& style) {
  const TypeStyle heading = LineStyle(LineKind::kHeading, style, script);
  std::map<std::pair<bool, std::size_t>, std::shared_ptr<const Group>> built;
  std::map<Relief, Group> sheets;
  const std::shared_ptr<const GrooveLinks> kept = LinksOf(page, script, style);
  const GrooveLinks& links = *kept;
  const std::vector<Placement> placed_links = LinkPlacements(links, script, style);
  std::size_t next_link = 0;
  for (std::size_t i = 0; i < page.glyphs.size();) {
    Group line;
    const std::size_t number = page.glyphs[i].line;
    const bool is_heading = page.glyphs[i].kind == LineKind::kHeading;
    const TypeStyle& own = is_heading ? heading : style;
    for (; i < page.glyphs.size() && page.glyphs[i].line == number; ++i) {
      const PlacedGlyph& placed = page.glyphs[i];
      auto& group = built[{is_heading, placed.glyph}];
      if (!group) group = Finish(BuildGlyph(script.glyphs.at(placed.glyph), own));
      line.placements.push_back({group, placed.origin_P});
    }
    for (; next_link < links.links.size() && links.links[next_link].from < i; ++next_link) {
      line.placements.push_back(placed_links[next_link]);
    }
    sheets[own.relief].placements.push_back({Finish(std::move(line)), {0, 0}});
  }
  Texture texture;
  for (auto& [relief, sheet] : sheets) {
    texture.layers.push_back({Finish(std::move(sheet)), relief});
  }
  AddRules(page, script, style, texture);
  AddSheetTexture(page, style, texture);
  AddStructurePatches(page, script, style, texture);
  return texture;
}

}  // namespace moontrace
