#pragma once

#include <cstdint>

namespace moontrace {

/// The SplitMix64 generator (Steele, Lea, Flood 2014): the same numbers with every compiler and
/// standard library, unlike the distributions of <random>.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t Bits() noexcept {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// Evenly from [0, 1), multiples of 2^-53.
  double Uniform() noexcept { return static_cast<double>(Bits() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

}  // namespace moontrace
