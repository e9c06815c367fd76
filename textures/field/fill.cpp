#include "textures/field/fill.h"

#include <algorithm>
#include <cmath>

#include "textures/base/overload.h"
#include "textures/base/units.h"

namespace moontrace {

namespace {

void AddStraight(glm::dvec2 a, glm::dvec2 b, std::vector<RisingEdge>& edges) {
  if (a.y > b.y) std::swap(a, b);
  if (a.y < b.y) edges.push_back({a.y, b.y, a.x, b.x, {0, 0}, 0});
}

/// Adds an arc, cut where it passes the top or the bottom of its circle.
void AddArc(const Arc& arc, std::vector<RisingEdge>& edges) {
  constexpr double kHalfTurn = kTurn / 2;
  const double sweep = SweepOf(arc);
  const double low = std::min(arc.start, arc.start + sweep);
  const double high = std::max(arc.start, arc.start + sweep);
  std::vector<double> cuts = {low};
  for (double turn = kHalfTurn * (std::floor(low / kHalfTurn - 0.5) + 1.5); turn < high;
       turn += kHalfTurn) {
    cuts.push_back(turn);
  }
  cuts.push_back(high);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const bool right = std::cos(0.5 * (cuts[i] + cuts[i + 1])) > 0;
    // ends of the whole arc are taken from PointAt's formula so that neighbours meet to the bit
    const glm::dvec2 a = arc.center + arc.radius * DirectionOf(cuts[i]);
    const glm::dvec2 b = arc.center + arc.radius * DirectionOf(cuts[i + 1]);
    const bool rises = a.y < b.y;
    const glm::dvec2 bottom = rises ? a : b, top = rises ? b : a;
    if (bottom.y < top.y) {
      edges.push_back(
          {bottom.y, top.y, bottom.x, top.x, arc.center, right ? arc.radius : -arc.radius});
    }
  }
}

}  // namespace

std::vector<RisingEdge> RisingEdges(const std::vector<Piece>& outline) {
  std::vector<RisingEdge> edges;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    std::visit(Overload{[&edges](const Line& line) { AddStraight(line.from, line.to, edges); },
                        [&edges](const Arc& arc) { AddArc(arc, edges); }},
               outline[i]);
    // pieces meet only to rounding: bridge the gap, so that the outline is closed for the ray
    const Piece& next = outline[(i + 1) % outline.size()];
    AddStraight(EndOf(outline[i]), StartOf(next), edges);
  }
  return edges;
}

bool IsInside(const std::vector<Piece>& outline, glm::dvec2 p) {
  bool inside = false;
  for (const RisingEdge& edge : RisingEdges(outline)) inside ^= Crosses(edge, p);
  return inside;
}

}  // namespace moontrace
