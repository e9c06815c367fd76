#include "devices/hand/tremor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace moontrace {
namespace {

constexpr double kPi = 3.14159265358979323846;

std::vector<glm::dvec3> Samples(Tremor tremor, int count) {
  std::vector<glm::dvec3> samples;
  for (int i = 0; i < count; ++i) samples.push_back(tremor.Next());
  return samples;
}

/// Amplitude of the sinusoid at `hertz` in one axis, through a Hann window, which keeps a line's
/// own leakage 10 / (duration) away below one part in a thousand.
double AmplitudeAt(const std::vector<glm::dvec3>& samples, int axis, double hertz, double tick) {
  std::complex<double> sum{0, 0};
  const double count = static_cast<double>(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double n = static_cast<double>(i);
    const double window = 1 - std::cos(2 * kPi * n / count);
    sum += window * samples[i][axis] * std::polar(1.0, -2 * kPi * hertz * n * tick);
  }
  return 2 * std::abs(sum) / count;
}

TEST(Tremor, HasItsRmsOnEachAxis) {
  const double rms = 1e-4;
  const int count = 100000;  // 100 s
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const auto samples = Samples(Tremor(rms, 8, 12, 0.001, seed), count);
    for (int axis = 0; axis < 3; ++axis) {
      double square = 0;
      for (const glm::dvec3& p : samples) square += p[axis] * p[axis];
      // Eight sinusoids of amplitude A = rms / 2: each of their 28 pairs beats at 0.25 Hz or more,
      // so over T = 100 s adds at most A^2 / (pi 0.25 Hz T) = 0.0032 rms^2; sums of two
      // frequencies (16 Hz or more, 36 of them) add at most 36 A^2 / (2 pi 16 Hz T) = 0.001 rms^2.
      EXPECT_NEAR(square / count / (rms * rms), 1, 28 * 0.0032 + 0.001) << seed << " " << axis;
    }
  }
}

TEST(Tremor, LiesInItsBand) {
  const auto samples = Samples(Tremor(1e-4, 8, 12, 0.001, 7), 20000);
  for (int axis = 0; axis < 3; ++axis) {
    for (double hertz = 0; hertz < 40; hertz += 0.25) {
      // One part in a thousand (see AmplitudeAt) of the eight amplitudes of 0.05 mm.
      if (hertz < 7.5 || hertz > 12.5) {
        EXPECT_LT(AmplitudeAt(samples, axis, hertz, 0.001), 8 * 5e-8) << hertz;
      }
    }
    // Eight lines of 0.05 mm at least 0.25 Hz apart: one near the middle of each half hertz.
    for (int part = 0; part < 8; ++part) {
      double most = 0;
      for (double hertz = 8.1 + 0.5 * part; hertz < 8.4 + 0.5 * part; hertz += 0.01) {
        most = std::max(most, AmplitudeAt(samples, axis, hertz, 0.001));
      }
      EXPECT_NEAR(most, 5e-5, 2e-6) << part;
    }
  }
}

TEST(Tremor, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const auto a = Samples(Tremor(1e-4, 8, 12, 0.001, 1), 1000);
  EXPECT_EQ(a, Samples(Tremor(1e-4, 8, 12, 0.001, 1), 1000));
  const auto b = Samples(Tremor(1e-4, 8, 12, 0.001, 2), 1000);
  double product = 0;
  for (std::size_t i = 0; i < a.size(); ++i) product += glm::dot(a[i], b[i]);
  EXPECT_LT(std::abs(product / 1000), 0.6 * 3e-8);  // one second is ten periods: loosely unlike
}

// Twice as long a tick must meet the same signal at every second sample: the phases of each are
// reached by another number of rotations and anchors.
TEST(Tremor, StaysExactOverAMillionTicks) {
  Tremor fine(1e-4, 8, 12, 0.001, 3), coarse(1e-4, 8, 12, 0.002, 3);
  double greatest = 0;
  for (int i = 0; i < 500000; ++i) {
    const glm::dvec3 a = fine.Next(), b = coarse.Next();
    fine.Next();
    greatest = std::max(greatest, glm::length(a - b));
  }
  // 10^4 turns carry an error of 10^4 * 2^-53 turns = 7e-12 rad; 24 lines of 0.05 mm.
  EXPECT_LT(greatest, 24 * 5e-5 * 1e-11);
}

}  // namespace
}  // namespace moontrace
