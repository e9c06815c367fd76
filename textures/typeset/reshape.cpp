#include "textures/typeset/reshape.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "textures/base/error.h"
#include "textures/base/overload.h"
#include "textures/base/units.h"
#include "textures/fonts/arc_fit.h"

namespace moontrace {
namespace {

constexpr double kTolerance = 0.001;                        // of refitted arcs [em]
constexpr double kMostSlant = std::numbers::pi / 6 + 1e-9;  // [rad]
constexpr double kLeastStretch = 0.5, kMostStretch = 2;

// x = stretch x + lean (y - fixed).
struct Map {
  double stretch = 1, lean = 0, fixed = 0;
  glm::dvec2 Point(glm::dvec2 p) const { return {stretch * p.x + lean * (p.y - fixed), p.y}; }
  glm::dvec2 Direction(glm::dvec2 v) const { return {stretch * v.x + lean * v.y, v.y}; }
};

// Quarter turns at most: a whole ellipse ends where it starts and has no chord to begin from.
void AppendArc(const Arc& arc, const Map& map, std::vector<Piece>& pieces) {
  const double sweep = SweepOf(arc);
  const double parts = std::max(1.0, std::ceil(std::abs(sweep) / (std::numbers::pi / 2) - 1e-9));
  for (double part = 0; part < parts; ++part) {
    const Piece quarter =
        Arc{arc.center, arc.radius, arc.start + sweep * part / parts, sweep / parts};
    const double length = Length(quarter);
    const Curve curve{
        [=](double t) { return map.Point(PointAt(quarter, t * length)); },
        [=](double t) { return length * map.Direction(TangentAt(quarter, t * length)); }};
    for (const Piece& fitted : FitArcs(curve, kTolerance)) pieces.push_back(fitted);
  }
}

std::vector<Piece> Mapped(const std::vector<Piece>& from, const Map& map) {
  std::vector<Piece> pieces;
  for (const Piece& piece : from) {
    std::visit(Overload{[&](const Line& line) {
                          pieces.emplace_back(Line{map.Point(line.from), map.Point(line.to)});
                        },
                        [&](const Arc& arc) { AppendArc(arc, map, pieces); }},
               piece);
  }
  return pieces;
}

void MoveDot(const Map& map, Stroke& stroke) {
  for (Piece& piece : stroke.pieces) {
    std::visit(Overload{[](Line&) {}, [&map](Arc& arc) { arc.center = map.Point(arc.center); }},
               piece);
  }
}

void Check(const Script& script, const LetterForm& form) {
  if (!script.braille_tables.empty()) {
    throw InputError(
        fmt::format("script {}: Braille dots stand at standard distances, which slant and stretch "
                    "would change: leave them out",
                    script.name));
  }
  // Written so that a NaN fails.
  if (!(std::abs(form.slant) <= kMostSlant && form.stretch >= kLeastStretch &&
        form.stretch <= kMostStretch)) {
    throw InputError(
        fmt::format("letters of slant {:.4g} degrees and stretch {:.4g}: give -30 to 30 degrees "
                    "and 0.5 to 2",
                    InDegrees(form.slant), form.stretch));
  }
}

Map MapOf(const LetterForm& form) {
  return {form.stretch, std::tan(form.slant), form.slant < 0 ? 1.0 : 0.0};
}

}  // namespace

double FootShift(const LetterForm& form) { return MapOf(form).Point({0, 0}).x; }

Script Reshaped(const Script& script, const LetterForm& form) {
  if (form == LetterForm{}) return script;
  Check(script, form);
  const Map map = MapOf(form);
  Script result = script;
  result.space_advance *= form.stretch;
  for (Glyph& glyph : result.glyphs) {
    glyph.advance *= form.stretch;
    for (Stroke& stroke : glyph.strokes) {
      if (stroke.kind == StrokeKind::kDot) {
        MoveDot(map, stroke);
      } else {
        stroke.pieces = Mapped(stroke.pieces, map);
      }
    }
  }
  return result;
}

}  // namespace moontrace
