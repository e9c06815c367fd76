#include "devices/drift.h"

#include <cmath>

namespace moontrace {
namespace {

constexpr double kTurn = 6.283185307179586476925;

}  // namespace

Drift::Drift(double share, double wavelength, const TickMotion& relax, std::uint64_t seed)
    : reach_(share * wavelength / kTurn),
      wave_number_(kTurn / wavelength),
      relax_(relax),
      random_(seed) {
  Begin();
}

void Drift::Begin() noexcept {
  offset_ = {0, 0};
  rate_ = {0, 0};
  travelled_ = 0;
  phase_ = kTurn * random_.Uniform();
  cosine_ = std::cos(phase_);
}

void Drift::Travel(glm::dvec2 step) noexcept {
  const double length = std::sqrt(step.x * step.x + step.y * step.y);
  if (!(length > 0)) return;
  travelled_ += length;
  // The integral of the sine over this bit of way, in closed form.
  const double cosine = std::cos(wave_number_ * travelled_ + phase_);
  const double aside = reach_ * (cosine_ - cosine);
  cosine_ = cosine;
  offset_ += aside / length * glm::dvec2(-step.y, step.x);
}

void Drift::Relax() noexcept {
  Move(relax_, offset_.x, rate_.x, 0);
  Move(relax_, offset_.y, rate_.y, 0);
}

}  // namespace moontrace
