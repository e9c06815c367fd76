#include "textures/objects/solid_contact.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace moontrace {
namespace {

const TextureField& Blank() noexcept {
  static const TextureField blank;
  return blank;
}

const TextureField& FieldOf(const LabelOnSolid& label) noexcept {
  return label.field != nullptr ? *label.field : Blank();
}

double RadiusOf(const Solid& solid) noexcept { return 2 * GreatestDepth(solid); }

/// min(k x+, limit).
double Saturating(double stiffness, double limit, double x) noexcept {
  return std::clamp(stiffness * x, 0.0, limit);
}

}  // namespace

double ThroughDepthOn(const Solid& solid, const Surface& surface,
                      std::span<const LabelOnSolid> labels) noexcept {
  double depth = ThroughDepth(surface, Blank());
  for (const LabelOnSolid& label : labels) {
    depth = std::max(depth, ThroughDepth(surface, FieldOf(label)));
  }
  return std::min(depth, GreatestDepth(solid));
}

SurfaceLaw LawOn(const Solid& solid, const Surface& surface,
                 std::span<const LabelOnSolid> labels) noexcept {
  const double shrink = ShrinkAt(solid, ThroughDepthOn(solid, surface, labels));
  SurfaceLaw law{.surface = surface};
  law.normal = kNormalShare * surface.force_cap;
  law.sideways = law.normal;
  double fall = 0, rise = 0;
  for (const LabelOnSolid& label : labels) {
    const TextureField& field = FieldOf(label);
    const double slope_bound = field.inverse_slope_bound() / (shrink * label.stretch);
    law.sideways = std::min(law.sideways, kSidewaysShare * surface.force_cap * slope_bound);
    fall = std::max(fall, field.greatest_fall());
    rise = std::max(rise, field.greatest_rise());
  }
  law.support = std::max(0.0, std::max(law.sideways / surface.stiffness, fall) - rise);
  return law;
}

double CarriedPressOn(const Solid& solid, const Surface& surface,
                      std::span<const LabelOnSolid> labels) noexcept {
  double press = CarriedPress(surface, Blank());
  double fall = 0;
  for (const LabelOnSolid& label : labels) {
    press = std::min(press, CarriedPress(surface, FieldOf(label)));
    fall = std::max(fall, FieldOf(label).greatest_fall());
  }
  const double room = ThroughDepthOn(solid, surface, labels) - fall;
  return std::min(press, std::max(0.0, surface.stiffness * room));
}

double StiffnessOn(const Solid& solid, const Surface& surface,
                   std::span<const LabelOnSolid> labels) noexcept {
  const double shrink = ShrinkAt(solid, ThroughDepthOn(solid, surface, labels));
  double stiffness = GreatestStiffness(surface, Blank(), surface.force_cap);
  for (const LabelOnSolid& label : labels) {
    const double steeper = shrink * label.stretch;
    stiffness =
        std::max(stiffness,
                 steeper * steeper * GreatestStiffness(surface, FieldOf(label), surface.force_cap));
  }
  // at half the radius the normal turns by 2 / radius
  return stiffness + surface.force_cap * 2 / RadiusOf(solid);
}

SolidContact TouchSolid(const SurfaceLaw& law, const Solid& solid,
                        std::span<const LabelOnSolid> labels, glm::dvec3 p_O,
                        const Sides& sides) noexcept {
  SolidContact contact;
  if (!std::isfinite(p_O.x + p_O.y + p_O.z)) return contact;
  contact.nearest = NearestOf(solid, p_O, sides);
  const glm::dvec3& normal = contact.nearest.normal_O;
  for (const LabelOnSolid& label : labels) {
    if (label.field == nullptr || label.chart.place().face != contact.nearest.face) continue;
    const LabelChart::Point at = label.chart.At(p_O);
    const Sample sample = label.field->SampleAt(at.p_P);
    contact.displacement += sample.displacement;
    contact.gradient_O += sample.gradient.x * at.dx_O + sample.gradient.y * at.dy_O;
  }
  const double k = law.surface.stiffness;
  contact.depth = contact.displacement - contact.nearest.height;
  if (law.surface.law == ForceLaw::kPaper) {
    if (!(contact.depth > 0)) return contact;
    contact.force_O = std::min(k * contact.depth, law.surface.force_cap) *
                      glm::normalize(normal - contact.gradient_O);
    return contact;
  }
  const double supported = -contact.nearest.height - law.support;
  if (!(contact.depth > 0) && !(supported > 0)) return contact;
  const double phi = Saturating(k, law.sideways, contact.depth);
  const double psi = Saturating(k, law.normal - law.sideways, supported);
  contact.force_O = phi * (normal - contact.gradient_O) + psi * normal;
  contact.depth = std::max(contact.depth, supported);
  return contact;
}

}  // namespace moontrace
