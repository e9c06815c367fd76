#include "sim/loop/pacing.h"

#include <algorithm>
#include <cmath>

namespace moontrace {

namespace {
/// A sleep on a stock kernel ends 30 to 70 us late with real-time priority. [ns]
constexpr std::int64_t kLongestSpin = 60'000;
}  // namespace

Pacing::Pacing(Clock& clock, double rate) noexcept
    : clock_(clock),
      period_(std::llround(1e9 / std::clamp(rate, kSlowestRate, kFastestRate))),
      // leaves the processor to others for a third of the time at least
      spin_(std::min(kLongestSpin, period_ * 6 / 10)) {}

Wake Pacing::Wait() noexcept {
  std::int64_t now = clock_.Now();
  if (next_ == 0) next_ = now;
  const std::int64_t deadline = next_;
  if (deadline - now > spin_) clock_.SleepUntil(deadline - spin_);
  now = clock_.Now();
  while (now < deadline) now = clock_.Now();
  Wake wake;
  wake.time = now;
  wake.lateness = now - deadline;
  wake.lost = static_cast<std::uint64_t>(wake.lateness / period_);
  next_ = deadline + (1 + static_cast<std::int64_t>(wake.lost)) * period_;
  return wake;
}

}  // namespace moontrace
