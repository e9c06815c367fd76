#include "devices/hand/drift.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "textures/base/units.h"

namespace moontrace {

Drift::Drift(double share, double wavelength, const TickMotion& relax, std::uint64_t seed)
    : reach_(share * wavelength / kTurn),
      wave_number_(kTurn / wavelength),
      relax_(relax),
      random_(seed) {
  Begin();
}

void Drift::Begin() noexcept {
  aside_ = 0;
  left_ = rest_ = rest_rate_ = {0, 0};
  travelled_ = 0;
  phase_ = kTurn * random_.Uniform();
  cosine_ = std::cos(phase_);
}

void Drift::Travel(glm::dvec2 step) noexcept {
  Settle();
  const double length = std::sqrt(step.x * step.x + step.y * step.y);
  if (!(length > 0)) return;
  const glm::dvec2 left(-step.y / length, step.x / length);
  rest_ += aside_ * (left_ - left);  // a turn does not move the offset at once
  left_ = left;
  travelled_ += length;
  // The integral of the sine over this bit of path, in closed form.
  const double cosine = std::cos(wave_number_ * travelled_ + phase_);
  aside_ += reach_ * (cosine_ - cosine);
  cosine_ = cosine;
}

void Drift::Relax() noexcept {
  rest_ += aside_ * left_;
  aside_ = 0;
  Settle();
}

void Drift::Settle() noexcept {
  // Below a picometre it is gone; going on would end in denormal numbers, which are slow.
  if (glm::dot(rest_, rest_) + glm::dot(rest_rate_, rest_rate_) < 1e-24) {
    rest_ = rest_rate_ = {0, 0};
    return;
  }
  Move(relax_, rest_.x, rest_rate_.x, 0);
  Move(relax_, rest_.y, rest_rate_.y, 0);
}

}  // namespace moontrace
