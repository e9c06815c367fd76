#pragma once

#include <cstddef>
#include <vector>

namespace moontrace {

/// How smooth one movement was. All zero where it was too short to measure.
struct Smoothness {
  double normalised_jerk = 0;  ///< dimensionless, >= 0; least, 720, for a minimum-jerk move
  double log_jerk = 0;         ///< log dimensionless jerk; closer to zero is smoother
  double spectral_arc = 0;     ///< SPARC, < 0; closer to zero is smoother
  double peaks = 0;            ///< of the speed: sub-movements
};

// Of a movement's speeds [m/s], taken at `rate` [Hz] from its start to its end. Jerk is that of
// the speed along the path, so that a letter's curves do not count as jerk. Zero for fewer than 7
// speeds and where nothing moved.

/// Integral of the squared jerk x T^5 / D^2, T the time and D the length of the path.
double NormalisedJerk(const std::vector<double>& speeds, double rate);

/// -ln(integral of the squared jerk x T^3 / greatest speed^2) (Balasubramanian, Melendez-Calderon,
/// Roby-Brami, Burdet 2015). -5.3220 for a minimum-jerk move.
double LogJerk(const std::vector<double>& speeds, double rate);

/// Arc length, negative, of the speeds' amplitude spectrum, normalised by its greatest value, up
/// to the last frequency below 10 Hz at which it reaches 0.05; zeros added to 2^4 times the next
/// power of two (the same paper). -1.4024 for a minimum-jerk move.
double SpectralArc(const std::vector<double>& speeds, double rate);

/// Peaks of the speed that stand out by 0.05 (ours) of the greatest; before the movement it is 0.
std::size_t SpeedPeaks(const std::vector<double>& speeds);

Smoothness SmoothnessOf(const std::vector<double>& speeds, double rate);

}  // namespace moontrace
