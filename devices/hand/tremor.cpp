#include "devices/hand/tremor.h"

#include <cmath>

#include "textures/base/random.h"
#include "textures/base/units.h"

namespace moontrace {
namespace {

/// One oscillator is anchored again every so many ticks, so each after 24 times as many: rotating
/// by products drifts by some 1e-16 a tick, far below a nanometre in that time.
constexpr std::uint64_t kAnchorTicks = 32;

}  // namespace

Tremor::Tremor(double rms, double low, double high, double tick, std::uint64_t seed)
    : amplitude_(rms * std::sqrt(2.0 / kPerAxis)) {
  Random random(seed);
  const double part = (high - low) / kPerAxis;
  for (std::size_t i = 0; i < kCount; ++i) {
    // Within the middle half of its part of the band, so that no two beat for long.
    const double place = static_cast<double>(i % kPerAxis) + 0.25 + 0.5 * random.Uniform();
    frequency_[i] = (low + part * place) * tick;
    phase_[i] = random.Uniform();
    step_cos_[i] = std::cos(kTurn * frequency_[i]);
    step_sin_[i] = std::sin(kTurn * frequency_[i]);
    Anchor(i);
  }
}

void Tremor::Anchor(std::size_t i) noexcept {
  const double turns = phase_[i] + frequency_[i] * static_cast<double>(tick_);
  const double angle = kTurn * (turns - std::floor(turns));
  cos_[i] = std::cos(angle);
  sin_[i] = std::sin(angle);
}

glm::dvec3 Tremor::Next() noexcept {
  glm::dvec3 sum{0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t begin = static_cast<std::size_t>(axis) * kPerAxis;
    for (std::size_t i = begin; i < begin + kPerAxis; ++i) sum[axis] += sin_[i];
  }
  for (std::size_t i = 0; i < kCount; ++i) {
    const double c = cos_[i];
    cos_[i] = c * step_cos_[i] - sin_[i] * step_sin_[i];
    sin_[i] = c * step_sin_[i] + sin_[i] * step_cos_[i];
  }
  ++tick_;
  if (tick_ % kAnchorTicks == 0) Anchor(tick_ / kAnchorTicks % kCount);
  return amplitude_ * sum;
}

}  // namespace moontrace
