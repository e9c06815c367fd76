#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>

#include "textures/base/units.h"
#include "textures/field/element.h"

/// What the plain paper texture and the compiled one share.
namespace moontrace {

/// 256 unit vectors, evenly around.
struct LatticeDirections {
  std::array<glm::dvec2, 256> unit{};
  LatticeDirections() {
    for (std::size_t i = 0; i < unit.size(); ++i) {
      const double angle = kTurn * (static_cast<double>(i) + 0.5) / 256;
      unit[i] = {std::cos(angle), std::sin(angle)};
    }
  }
};
inline const LatticeDirections kLatticeDirections;

/// The products that the hash of a lattice point begins with; they step by a constant from point to
/// point.
inline constexpr std::uint32_t kHashColumn = 0x9E3779B1u, kHashRow = 0x85EBCA77u;

/// A unit vector for a lattice point, drawn by an integer hash of `mixed` = column * kHashColumn +
/// row * kHashRow + seed (multiply and shift; the multiplier is that of Steele's and Vigna's tables
/// of good ones, 2021).
inline const glm::dvec2& LatticeDirection(std::uint32_t mixed) noexcept {
  mixed ^= mixed >> 16;
  mixed *= 0xADB4A92Du;
  return kLatticeDirections.unit[mixed >> 24];
}

/// Cells of the lattice per wavelength: gradient noise of cell c crosses zero 0.97 times a cell
/// along a line, a wave twice a wavelength.
inline constexpr double kCellsPerWavelength = 2;

/// Share of the texture at a place along one side of a patch, and its derivative [1/m].
struct BorderFade {
  double share = 1;
  double slope = 0;
};
/// `from` the lower border, `to` the upper one, both >= 0 [m]; C1 and even in both.
inline BorderFade FadeAt(double from, double to, double per_m) noexcept {
  const double t = std::fmin(from, to) * per_m;
  if (!(t < 1)) return {};
  const double slope = 6 * t * (1 - t) * per_m;
  return {t * t * (3 - 2 * t), from <= to ? slope : -slope};
}

/// Length of a patch's fade: at most half its shorter side [m].
inline double FadeLength(const Box& box, double fade) noexcept {
  return std::fmin(fade, 0.5 * std::fmin(box.max.x - box.min.x, box.max.y - box.min.y));
}

/// A product with the fade: the sample within a patch.
inline void Multiply(glm::dvec2& gradient, double& height, const BorderFade& x,
                     const BorderFade& y) noexcept {
  gradient = {gradient.x * x.share * y.share + height * x.slope * y.share,
              gradient.y * x.share * y.share + height * x.share * y.slope};
  height *= x.share * y.share;
}

}  // namespace moontrace
