#include "sim/reading/senses.h"

namespace moontrace {

ReaderInput LateSenses::Pass(const ReaderInput& now) noexcept {
  kept_[slot_] = now;
  slot_ = slot_ + 1 == kept_.size() ? 0 : slot_ + 1;
  ReaderInput late = kept_[slot_];
  late.time = now.time;
  return late;
}

// With s = tick / lag the inner lag's variance is kick^2 / (2 s) and the outer one's half of that,
// both to first order in s. Even noise within +-1 has a variance of a third.
UnsurePlace::UnsurePlace(double rms, double tick, std::uint64_t seed)
    : share_(tick / kLag), kick_(rms * std::sqrt(12 * tick / kLag)), random_(seed) {
  // as if it had wandered for ever
  const auto settled = static_cast<int>(10 / share_);
  for (int i = 0; rms > 0 && i < settled; ++i) Next();
}

glm::dvec2 UnsurePlace::Next() noexcept {
  if (kick_ <= 0) return error_;
  const double x = 2 * random_.Uniform() - 1;
  const double y = 2 * random_.Uniform() - 1;
  inner_ += kick_ * glm::dvec2(x, y) - share_ * inner_;
  error_ += share_ * (inner_ - error_);
  return error_;
}

}  // namespace moontrace
