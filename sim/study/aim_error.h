#pragma once

#include <cstdint>
#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <string_view>

namespace moontrace {

/// How the aim of a hand lies beside where it should: a shift, a turn and a distortion of the page
/// as the hand imagines it, of root mean square 1 over a letter's box. The same seed and name, the
/// same error.
class AimError {
 public:
  AimError(std::uint64_t seed, std::string_view name);
  /// At a point of the box, which reaches from -0.5 to 0.5.
  glm::dvec2 At(glm::dvec2 u) const { return shift_ + distortion_ * u; }

 private:
  glm::dvec2 shift_{0, 0};
  glm::dmat2 distortion_{0.0};
};

/// A pseudo-random number that depends on these two alone.
std::uint64_t SeedOf(std::uint64_t seed, std::string_view name);

}  // namespace moontrace
