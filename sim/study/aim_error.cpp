#include "sim/study/aim_error.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "textures/base/digest.h"
#include "textures/base/random.h"

namespace moontrace {

std::uint64_t SeedOf(std::uint64_t seed, std::string_view name) {
  return Random(DigestOf(name) ^ Random(seed).Bits()).Bits();
}

AimError::AimError(std::uint64_t seed, std::string_view name) {
  Random random(SeedOf(seed, name));
  const auto even = [&random] { return 2 * random.Uniform() - 1; };
  shift_ = {even(), even()};
  for (int column = 0; column < 2; ++column) {
    for (int row = 0; row < 2; ++row) distortion_[column][row] = even();
  }
  // Mean square over the box: each coordinate's is 1/12, and none goes with another.
  double square = glm::dot(shift_, shift_);
  for (int column = 0; column < 2; ++column) {
    square += glm::dot(distortion_[column], distortion_[column]) / 12;
  }
  const double scale = 1 / std::sqrt(square + 1e-12);
  shift_ *= scale;
  distortion_ *= scale;
}

}  // namespace moontrace
