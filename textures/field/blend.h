#pragma once

#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>

#include "textures/field/element.h"

namespace moontrace {

/// The nearest point of a line or an arc, as blending needs it.
struct Foot {
  double distance = 0;            ///< d, from the spine [m]; below zero: the element does not reach
  glm::dvec2 gradient{0.0, 0.0};  ///< of d, unit; zero on the spine
  double inset = 0;               ///< t, of the foot from the nearer end along the spine [m]
  glm::dvec2 inset_gradient{0.0, 0.0};  ///< of t
  std::size_t profile = 0;              ///< its number: only elements of equal profile blend
};

/// Distance after blending, and its gradient.
struct BlendedDistance {
  double distance = 0;            ///< [m], may be below zero where spines cross
  glm::dvec2 gradient{0.0, 0.0};  ///< [m/m]
};

/// Rounds the crease between a group's lines and arcs over the radius rho, as a weld's fillet does:
///   d_i' = d_i - max over j of w(t_i) w(t_j) (rho - |d_j - d_i|)^2 / (4 rho), where |d_j - d_i| <
///   rho,
/// the quadratic smooth minimum, weighted by w(t) = smoothstep(t / rho). A foot at an end has
/// weight zero: line, cap and the next piece of one stroke meet there already and must not swell.
/// The greatest of the pairs counts, not their sum: where a dozen strokes run side by side, a sum
/// would swell them all and make flanks many times as steep as the profile's. Ours.
/// `feet[j]` for j below `count` gives a Foot.
template <typename Feet>
BlendedDistance Blend(const Feet& feet, std::size_t count, std::size_t i, double rho) noexcept {
  const auto weight = [rho](const Foot& foot) {
    const double u = std::fmin(foot.inset / rho, 1.0);
    return u * u * (3 - 2 * u);
  };
  const auto weight_gradient = [rho](const Foot& foot) {
    const double u = std::fmin(foot.inset / rho, 1.0);
    return 6 * u * (1 - u) / rho * foot.inset_gradient;
  };
  const Foot own = feet[i];
  BlendedDistance blended{own.distance, own.gradient};
  for (std::size_t j = 0; j < count; ++j) {
    const Foot other = feet[j];
    const double gap = other.distance - own.distance;
    if (j == i || other.distance < 0 || other.profile != own.profile || std::abs(gap) >= rho) {
      continue;
    }
    const double q = rho - std::abs(gap);
    const double w = weight(own) * weight(other);
    const double distance = own.distance - w * q * q / (4 * rho);
    if (!(distance < blended.distance)) continue;
    blended.distance = distance;
    blended.gradient =
        own.gradient -
        q * q / (4 * rho) *
            (weight_gradient(own) * weight(other) + weight(own) * weight_gradient(other)) +
        (gap < 0 ? -1.0 : 1.0) * w * q / (2 * rho) * (other.gradient - own.gradient);
  }
  return blended;
}

/// How far beyond its rim an element of a group with `members` lines and arcs can reach by blending
/// [m].
inline double BlendReach(std::size_t members, double rho) noexcept {
  return members < 2 ? 0 : 0.25 * rho;
}

}  // namespace moontrace
