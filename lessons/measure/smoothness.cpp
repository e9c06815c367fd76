#include "lessons/measure/smoothness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "textures/base/units.h"

namespace moontrace {
namespace {

constexpr std::size_t kFewest = 7;   ///< speeds: five of jerk, as the corrected integral needs
constexpr double kSpectrumEnd = 10;  ///< [Hz]
constexpr double kSpectrumThreshold = 0.05;
constexpr int kSpectrumPadding = 4;
constexpr double kPeakProminence = 0.05;  ///< of the greatest speed

bool IsLongEnough(const std::vector<double>& speeds, double rate) {
  return speeds.size() >= kFewest && rate > 0 &&
         *std::max_element(speeds.begin(), speeds.end()) > 0;
}

/// Integral of evenly spaced values: trapezia with Gregory's end corrections of first and second
/// order, so that smooth curves need no fine steps.
double Integral(const std::vector<double>& values, double step) {
  const std::size_t n = values.size() - 1;
  const double ends = (values[0] + values[n]) / 2;
  const double sum = std::accumulate(values.begin(), values.end(), 0.0) - ends;
  const double first = (values[n] - values[n - 1]) - (values[1] - values[0]);
  const double second =
      (values[n] - 2 * values[n - 1] + values[n - 2]) + (values[2] - 2 * values[1] + values[0]);
  return step * (sum - first / 12 - second / 24);
}

/// Second derivative of the speed, squared. The ends are continued from within as a parabola,
/// which a minimum-jerk move's jerk is: outside the movement nothing is known.
double SquaredJerk(const std::vector<double>& speeds, double rate) {
  const std::size_t n = speeds.size();
  std::vector<double> jerk(n);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    jerk[i] = (speeds[i + 1] - 2 * speeds[i] + speeds[i - 1]) * rate * rate;
  }
  jerk[0] = 3 * jerk[1] - 3 * jerk[2] + jerk[3];
  jerk[n - 1] = 3 * jerk[n - 2] - 3 * jerk[n - 3] + jerk[n - 4];
  for (double& value : jerk) value *= value;
  return Integral(jerk, 1 / rate);
}

double TimeOf(const std::vector<double>& speeds, double rate) {
  return static_cast<double>(speeds.size() - 1) / rate;
}

constexpr std::size_t kAtOnce = 8;  ///< bins: each value waits for the last, so several go abreast

/// Magnitudes of the speeds' Fourier sum at `first` and the bins after it, `turn` [rad per value]
/// for each bin, by Horner's rule.
std::array<double, kAtOnce> Amplitudes(const std::vector<double>& speeds, std::size_t first,
                                       double turn) {
  std::array<double, kAtOnce> c{}, s{}, re{}, im{};
  for (std::size_t k = 0; k < kAtOnce; ++k) {
    c[k] = std::cos(turn * static_cast<double>(first + k));
    s[k] = std::sin(turn * static_cast<double>(first + k));
  }
  for (auto value = speeds.rbegin(); value != speeds.rend(); ++value) {
    for (std::size_t k = 0; k < kAtOnce; ++k) {
      const double turned = re[k] * c[k] - im[k] * s[k] + *value;
      im[k] = re[k] * s[k] + im[k] * c[k];
      re[k] = turned;
    }
  }
  for (std::size_t k = 0; k < kAtOnce; ++k) re[k] = std::hypot(re[k], im[k]);
  return re;
}

std::size_t PaddedSize(std::size_t size) {
  std::size_t padded = 1;
  while (padded < size) padded *= 2;
  return padded << kSpectrumPadding;
}

}  // namespace

double NormalisedJerk(const std::vector<double>& speeds, double rate) {
  if (!IsLongEnough(speeds, rate)) return 0;
  const double distance = Integral(speeds, 1 / rate);
  return SquaredJerk(speeds, rate) * std::pow(TimeOf(speeds, rate), 5) / (distance * distance);
}

double LogJerk(const std::vector<double>& speeds, double rate) {
  if (!IsLongEnough(speeds, rate)) return 0;
  const double peak = *std::max_element(speeds.begin(), speeds.end());
  const double jerk = SquaredJerk(speeds, rate) * std::pow(TimeOf(speeds, rate), 3) / (peak * peak);
  return jerk > 0 ? -std::log(jerk) : 0;
}

double SpectralArc(const std::vector<double>& speeds, double rate) {
  if (!IsLongEnough(speeds, rate)) return 0;
  const auto size = static_cast<double>(PaddedSize(speeds.size()));
  const double end = std::min(kSpectrumEnd, rate / 2);
  const auto last_bin = static_cast<std::size_t>(end * size / rate);
  // Speeds are not negative, so the spectrum is greatest at 0 and the arc begins there.
  const double greatest = std::accumulate(speeds.begin(), speeds.end(), 0.0);
  std::vector<double> spectrum;
  for (std::size_t k = 0; k <= last_bin; k += kAtOnce) {
    for (const double amplitude : Amplitudes(speeds, k, kTurn / size)) {
      spectrum.push_back(amplitude / greatest);
    }
  }
  std::size_t last = last_bin;
  while (last > 0 && spectrum[last] < kSpectrumThreshold) --last;
  double arc = 0;
  for (std::size_t k = 1; k <= last; ++k) {
    arc += std::hypot(1 / static_cast<double>(last), spectrum[k] - spectrum[k - 1]);
  }
  return -arc;
}

std::size_t SpeedPeaks(const std::vector<double>& speeds) {
  if (speeds.empty()) return 0;
  const double prominence = kPeakProminence * *std::max_element(speeds.begin(), speeds.end());
  if (!(prominence > 0)) return 0;
  std::size_t peaks = 0;
  bool rising = false;
  double turn = 0;  // lowest since a peak, or highest while rising
  for (const double speed : speeds) {
    if (!rising && speed > turn + prominence) {
      rising = true;
      ++peaks;
      turn = speed;
    } else if (rising && speed < turn - prominence) {
      rising = false;
      turn = speed;
    } else {
      turn = rising ? std::max(turn, speed) : std::min(turn, speed);
    }
  }
  return peaks;
}

Smoothness SmoothnessOf(const std::vector<double>& speeds, double rate) {
  Smoothness smoothness;
  if (!IsLongEnough(speeds, rate)) return smoothness;
  smoothness.normalised_jerk = NormalisedJerk(speeds, rate);
  smoothness.log_jerk = LogJerk(speeds, rate);
  smoothness.spectral_arc = SpectralArc(speeds, rate);
  smoothness.peaks = static_cast<double>(SpeedPeaks(speeds));
  return smoothness;
}

}  // namespace moontrace
