#include "textures/field/surface.h"

#include <algorithm>
#include <cmath>

namespace moontrace {

namespace {

/// Greatest derivative of the potential: with the greatest slope the force just reaches the cap.
double SaturatedForce(const Surface& surface, const TextureField& field) noexcept {
  return surface.force_cap * field.steepest_cosine();
}

}  // namespace

glm::dvec3 NormalOf(glm::dvec2 gradient) noexcept {
  const double scale = 1 / std::sqrt(1 + gradient.x * gradient.x + gradient.y * gradient.y);
  return {-gradient.x * scale, -gradient.y * scale, scale};
}

Contact Touch(const Surface& surface, const TextureField& field, glm::dvec3 p_P) noexcept {
  Contact contact;
  contact.sample = field.SampleAt({p_P.x, p_P.y});
  contact.depth = contact.sample.displacement - p_P.z;
  // infinitely deep is as broken as NaN; the sum is finite only if all three are
  if (!(contact.depth > 0) || !std::isfinite(contact.depth + p_P.x + p_P.y)) {
    return contact;
  }
  if (surface.law == ForceLaw::kPaper) {
    contact.force_P = std::min(surface.stiffness * contact.depth, surface.force_cap) *
                      NormalOf(contact.sample.gradient);
    return contact;
  }
  const double slope = std::min(surface.stiffness * contact.depth, SaturatedForce(surface, field));
  contact.force_P = slope * glm::dvec3(-contact.sample.gradient, 1.0);
  return contact;
}

double Potential(const Surface& surface, const TextureField& field, double depth) noexcept {
  if (!(depth > 0)) return 0;
  const double saturated = SaturatedForce(surface, field);
  const double knee = saturated / surface.stiffness;
  if (depth <= knee) return 0.5 * surface.stiffness * depth * depth;
  return 0.5 * surface.stiffness * knee * knee + saturated * (depth - knee);
}

double GreatestStiffness(const Surface& surface, const TextureField& field, double press) noexcept {
  const double s = field.greatest_slope();
  const double force = std::min(press, surface.force_cap);
  return surface.stiffness * (1 + s * s) + force * field.greatest_curvature();
}

}  // namespace moontrace
