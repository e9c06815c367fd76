#include "sim/physics/label_place.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace moontrace {
namespace {

LabelChart ChartOf(const Label& label, const Solid& solid, const Box& text_P) {
  return {solid, PlaceOn(label, solid, text_P)};
}

/// Whether a point of a grid over one label's text lies within another's.
bool HoldsSome(const LabelChart& chart, const Box& text_P, const LabelChart& other,
               const Box& other_P) {
  constexpr int kPoints = 16;
  for (int i = 0; i <= kPoints; ++i) {
    for (int k = 0; k <= kPoints; ++k) {
      const glm::dvec2 share = glm::dvec2(i, k) / static_cast<double>(kPoints);
      const glm::dvec2 p_P = text_P.min + share * (text_P.max - text_P.min);
      if (Contains(other_P, other.At(chart.ToObject({p_P, 0})).p_P)) return true;
    }
  }
  return false;
}

}  // namespace

std::optional<Solid> SolidOf(const mjModel& m, int geom) {
  const mjtNum* size = m.geom_size + std::ptrdiff_t{3} * geom;
  const glm::dvec3 half(size[0], size[1], size[2]);
  switch (m.geom_type[geom]) {
    case mjGEOM_PLANE:
      return Solid{SolidKind::kPlane, half};
    case mjGEOM_BOX:
      return Solid{SolidKind::kBox, half};
    case mjGEOM_CYLINDER:
      return Solid{SolidKind::kCylinder, half};
    case mjGEOM_SPHERE:
      return Solid{SolidKind::kSphere, half};
    case mjGEOM_CAPSULE:
      return Solid{SolidKind::kCapsule, half};
    case mjGEOM_ELLIPSOID:
      return Solid{SolidKind::kEllipsoid, half};
    default:
      return std::nullopt;
  }
}

LabelPlace PlaceOn(const Label& label, const Solid& solid, const Box& text_P) {
  LabelPlace place{label.face.value_or(UsualFace(solid)), label.at, {0, 0}, label.turn};
  const bool round = place.face == Face::kRound;
  const bool known = text_P.min.x <= text_P.max.x;
  if (label.middle) place.on_face = *label.middle;
  if (!known || !(label.middle || round)) return place;
  place.on_page = 0.5 * (text_P.min + text_P.max);
  if (!label.middle) {
    const double c = std::cos(label.turn), s = std::sin(label.turn);
    place.on_face += glm::dvec2(c * place.on_page.x - s * place.on_page.y,
                                s * place.on_page.x + c * place.on_page.y);
  }
  return place;
}

LabelOnSolid Lay(const Label& label, const Solid& solid, const TextureField* field,
                 const Box& text_P) {
  LabelOnSolid laid{LabelChart(solid, PlaceOn(label, solid, text_P)), field, 1};
  const bool round = laid.chart.place().face == Face::kRound;
  if (round && text_P.min.x <= text_P.max.x) {
    laid.stretch = std::max(1.0, ScalesOf(laid.chart, text_P).greatest);
  }
  return laid;
}

glm::dvec2 ExtentOf(const Label& label, const Solid& solid) {
  const Face face = label.face.value_or(UsualFace(solid));
  const Box room = RoomOn(solid, face);
  glm::dvec2 extent = room.max - room.min;
  if (!label.middle && face != Face::kRound) extent = room.max - label.at;
  if (!label.middle && face == Face::kRound) extent.y = room.max.y - label.at.y;
  // a page on its side
  if (std::abs(std::sin(label.turn)) > std::sqrt(0.5)) std::swap(extent.x, extent.y);
  return extent;
}

bool HasRoom(const Label& label, const Solid& solid, const Box& text_P) {
  return Fits(solid, PlaceOn(label, solid, text_P), text_P);
}

double LengthErrorOf(const Label& label, const Solid& solid, const Box& text_P) {
  return LengthError(ChartOf(label, solid, text_P), text_P);
}

bool LieTogether(const Label& a, const Box& text_A, const Label& b, const Box& text_B,
                 const Solid& solid) {
  if (a.carrier != b.carrier) return false;
  const LabelChart chart_A = ChartOf(a, solid, text_A), chart_B = ChartOf(b, solid, text_B);
  return chart_A.place().face == chart_B.place().face &&
         (HoldsSome(chart_A, text_A, chart_B, text_B) ||
          HoldsSome(chart_B, text_B, chart_A, text_A));
}

}  // namespace moontrace
