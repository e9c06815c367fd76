#include "textures/field/profile.h"

#include <fmt/core.h>

#include <cmath>

#include "textures/base/error.h"
#include "textures/base/units.h"

namespace moontrace {

double GreatestSlope(const Profile& profile) {
  return profile.depth / (0.5 * profile.width - profile.rounding);
}

double GreatestCurvature(const Profile& profile) {
  return GreatestSlope(profile) / profile.rounding;
}

ProfileSample Evaluate(const Profile& profile, double distance) noexcept {
  const double r = profile.rounding;
  const double half = 0.5 * profile.width;
  const double s = profile.depth / (half - r);

  // rounded spine, straight flank, rounded rim: parabolas meeting the flank with equal slopes
  if (distance <= r) return {profile.depth - s * distance * distance / (2 * r), -s * distance / r};
  if (distance <= half - r) return {profile.depth - s * r / 2 - s * (distance - r), -s};
  if (distance < half) {
    const double to_rim = half - distance;
    return {s * to_rim * to_rim / (2 * r), -s * to_rim / r};
  }
  return {};
}

ProfileSample EvaluateFill(const Profile& profile, double inside) noexcept {
  const double half = 0.5 * profile.width;
  if (!(inside > 0)) return {};
  if (inside >= half) return {profile.depth, 0};
  const ProfileSample rim = Evaluate(profile, half - inside);
  return {rim.height, -rim.slope};
}

void Check(const Profile& profile) {
  const bool finite = std::isfinite(profile.width) && std::isfinite(profile.depth) &&
                      std::isfinite(profile.rounding);
  if (finite && profile.depth > 0 && profile.rounding > 0 &&
      profile.rounding <= profile.width / 4 * (1 + 1e-12)) {
    return;
  }
  throw InputError(fmt::format(
      "groove {:g} by {:g} mm, rounding {:g} mm: give all above 0, rounding to width / 4",
      kMillimetres * profile.width, kMillimetres * profile.depth, kMillimetres * profile.rounding));
}

}  // namespace moontrace
