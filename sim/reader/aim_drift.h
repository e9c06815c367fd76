#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "sim/reader/reader_knowledge.h"
#include "sim/reader/touch_sense.h"

namespace moontrace {

/// How far a hand strays from its aim over flat paper without meaning to, as it finds when it
/// compares where it feels itself to be with where it aimed at that time.
class AimDrift {
 public:
  AimDrift() = default;
  /// `tick` [s].
  AimDrift(const ReaderKnowledge& knowledge, double tick);

  /// A landing: it strays anew.
  void Begin() noexcept;
  /// One tick over the paper with this aim [m].
  void Add(const Felt& felt, glm::dvec2 aim) noexcept;
  glm::dvec2 drift() const { return drift_; }  ///< [m]

 private:
  double tick_ = 1e-3;
  std::vector<glm::dvec2> aims_;  ///< of the time by which it feels late, a ring buffer [m]
  std::size_t count_ = 0;
  glm::dvec2 drift_{0, 0};
};

}  // namespace moontrace
