#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

namespace moontrace {

/// The way of a tip in bounded memory: points at least a spacing apart; when there are kMost, every
/// second one goes and the spacing doubles.
class TipWay {
 public:
  static constexpr std::size_t kMost = 128;

  /// `spacing` [m].
  explicit TipWay(double spacing) : spacing_(spacing) {}
  void Add(glm::dvec2 p);
  /// With the newest one at the end [m].
  std::vector<glm::dvec2> Points() const;

 private:
  double spacing_ = 0;
  std::vector<glm::dvec2> points_;
  glm::dvec2 newest_{0, 0};
};

}  // namespace moontrace
