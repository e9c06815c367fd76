#pragma once

#include <numbers>

namespace moontrace {

/// A whole turn [rad].
inline constexpr double kTurn = 2 * std::numbers::pi;
/// A degree [rad].
inline constexpr double kDegree = std::numbers::pi / 180;
/// A millimetre [m].
inline constexpr double kMillimetre = 1e-3;
/// Millimetres in a metre.
inline constexpr double kMillimetres = 1e3;

/// A length [m] in millimetres.
constexpr double InMillimetres(double length) noexcept { return kMillimetres * length; }
/// An angle [rad] in degrees.
constexpr double InDegrees(double angle) noexcept { return angle * 180 / std::numbers::pi; }

}  // namespace moontrace
