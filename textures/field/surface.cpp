#include "textures/field/surface.h"

#include <algorithm>
#include <cmath>

namespace moontrace {

namespace {

constexpr double kReserve = 0.94;  ///< share of F_n that a lasting press may take
constexpr double kBeyond = 0.005;  ///< from full force to through: a landing that is not soft [m]

/// Integral of min(k x+, limit) [J].
double SaturatingEnergy(double stiffness, double limit, double x) noexcept {
  if (!(x > 0)) return 0;
  if (stiffness * x <= limit) return 0.5 * stiffness * x * x;
  return limit * (x - 0.5 * limit / stiffness);
}

double Saturating(double stiffness, double limit, double x) noexcept {
  return std::clamp(stiffness * x, 0.0, limit);
}

Contact ContactOf(const SurfaceLaw& law, const Sample& sample, glm::dvec3 p_P) noexcept {
  const Surface& surface = law.surface;
  Contact contact;
  contact.sample = sample;
  contact.depth = contact.sample.displacement - p_P.z;
  // infinitely deep is as broken as NaN; the sum is finite only if all three are
  if (!std::isfinite(contact.depth + p_P.x + p_P.y)) return contact;
  if (surface.law == ForceLaw::kPaper) {
    if (!(contact.depth > 0)) return contact;
    contact.force_P = std::min(surface.stiffness * contact.depth, surface.force_cap) *
                      NormalOf(contact.sample.gradient);
    return contact;
  }
  const double supported = -p_P.z - law.support;  // a - a0
  if (!(contact.depth > 0) && !(supported > 0)) return contact;
  const double phi = Saturating(surface.stiffness, law.sideways, contact.depth);
  const double psi = Saturating(surface.stiffness, law.normal - law.sideways, supported);
  contact.force_P = phi * glm::dvec3(-contact.sample.gradient, 1.0);
  contact.force_P.z += psi;
  contact.depth = std::max(contact.depth, supported);
  return contact;
}

}  // namespace

SurfaceLaw LawOf(const Surface& surface, const TextureField& field) noexcept {
  SurfaceLaw law{.surface = surface};
  law.normal = kNormalShare * surface.force_cap;
  law.sideways =
      std::min(law.normal, kSidewaysShare * surface.force_cap * field.inverse_slope_bound());
  law.support = std::max(law.sideways / surface.stiffness, field.greatest_fall());
  law.support = std::max(0.0, law.support - field.greatest_rise());
  return law;
}

glm::dvec3 NormalOf(glm::dvec2 gradient) noexcept {
  const double scale = 1 / std::sqrt(1 + gradient.x * gradient.x + gradient.y * gradient.y);
  return {-gradient.x * scale, -gradient.y * scale, scale};
}

Contact Touch(const Surface& surface, const TextureField& field, glm::dvec3 p_P) noexcept {
  return Touch(LawOf(surface, field), field, p_P);
}

Contact Touch(const SurfaceLaw& law, const TextureField& field, glm::dvec3 p_P) noexcept {
  return ContactOf(law, field.SampleAt({p_P.x, p_P.y}), p_P);
}

Contact Touch(const SurfaceLaw& law, const Sample& sample, glm::dvec3 p_P) noexcept {
  return ContactOf(law, sample, p_P);
}

double Potential(const SurfaceLaw& law, double displacement, double z) noexcept {
  const double k = law.surface.stiffness;
  return SaturatingEnergy(k, law.sideways, displacement - z) +
         SaturatingEnergy(k, law.normal - law.sideways, -z - law.support);
}

double CarriedPress(const Surface& surface, const TextureField& field) noexcept {
  if (surface.law == ForceLaw::kPotential) return kReserve * kNormalShare * surface.force_cap;
  const double s = field.greatest_slope();
  return kReserve * surface.force_cap / std::sqrt(1 + s * s);
}

double ThroughDepth(const Surface& surface, const TextureField& field) noexcept {
  const double lowest = field.greatest_fall();
  if (surface.law == ForceLaw::kPaper)
    return lowest + surface.force_cap / surface.stiffness + kBeyond;
  const SurfaceLaw law = LawOf(surface, field);
  return std::max(lowest + law.sideways / surface.stiffness,
                  law.support + (law.normal - law.sideways) / surface.stiffness) +
         kBeyond;
}

double GreatestStiffness(const Surface& surface, const TextureField& field, double press) noexcept {
  const double s2 = field.greatest_slope() * field.greatest_slope();
  if (surface.law == ForceLaw::kPaper) {
    return surface.stiffness * (1 + s2) +
           std::min(press, surface.force_cap) * field.greatest_curvature();
  }
  const SurfaceLaw law = LawOf(surface, field);
  const double both = law.sideways < law.normal ? 0.5 * (s2 + 2 + std::sqrt(s2 * s2 + 4)) : 1 + s2;
  return surface.stiffness * both + std::min(press, law.sideways) * field.greatest_curvature();
}

}  // namespace moontrace
