#include "sim/reader/aim_drift.h"

#include <cmath>

namespace moontrace {
namespace {

constexpr double kLearn = 0.25;  ///< several periods of a tremor [s]
constexpr double kFlat = 0.2;    ///< deeper, a groove leads the tip; share of its depth

}  // namespace

AimDrift::AimDrift(const ReaderKnowledge& knowledge, double tick)
    : tick_(tick),
      aims_(static_cast<std::size_t>(std::lround((knowledge.delay + knowledge.lag) / tick)) + 1,
            glm::dvec2(0, 0)) {}

void AimDrift::Begin() noexcept {
  count_ = 0;
  drift_ = {0, 0};
}

void AimDrift::Add(const Felt& felt, glm::dvec2 aim) noexcept {
  const std::size_t slot = count_ % aims_.size();
  const glm::dvec2 then = aims_[slot];
  aims_[slot] = aim;
  if (count_++ < aims_.size() || !felt.touching || felt.depth > kFlat) return;
  drift_ += tick_ / kLearn * (glm::dvec2(felt.tip) - then - drift_);
}

}  // namespace moontrace
