#pragma once

namespace moontrace {

/// Cross-section of a groove or a ridge: a triangle rounded at spine and rims (the paper, section
/// 4; design section 4, point 1). Heights are given as magnitudes; the layer's relief gives the
/// sign.
struct Profile {
  double width = 0;     ///< w, rim to rim [m], > 0
  double depth = 0;     ///< D, at the spine after rounding [m], > 0
  double rounding = 0;  ///< r, half the width of each rounded part [m], 0 < r <= w/4
};

/// Magnitude of the displacement and its derivative by the distance from the spine.
struct ProfileSample {
  double height = 0;  ///< [m], >= 0
  double slope = 0;   ///< d height / d distance [m/m], <= 0
};

/// Slope s of the straight flank, the greatest slope of the profile: D / (w/2 - r) [m/m].
double GreatestSlope(const Profile& profile);

/// Greatest second derivative of the profile, s / r [1/m].
double GreatestCurvature(const Profile& profile);

/// Magnitude at `distance` >= 0 [m] from the spine; zero at w/2 and beyond. C1 in the distance.
ProfileSample Evaluate(const Profile& profile, double distance) noexcept;

/// Magnitude for a fill: `inside` is the distance [m] from the outline, positive inside. Zero
/// outside, the same rim as the groove's, flat at the full depth from w/2 on.
ProfileSample EvaluateFill(const Profile& profile, double inside) noexcept;

/// Throws InputError unless 0 < r <= w/4, 0 < D and all are finite.
void Check(const Profile& profile);

}  // namespace moontrace
