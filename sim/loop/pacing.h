#pragma once

#include <cstdint>

#include "sim/loop/clock.h"

namespace moontrace {

inline constexpr double kSlowestRate = 250;    ///< [Hz]
inline constexpr double kFastestRate = 10000;  ///< [Hz]

/// One waking of the loop.
struct Wake {
  std::int64_t time = 0;      ///< [ns]
  std::int64_t lateness = 0;  ///< after the deadline that was waited for [ns], >= 0
  std::uint64_t lost = 0;     ///< periods that passed without a tick since the last waking
};

/// Absolute deadlines, a period apart from the first call on. A waking that comes later than a
/// whole period skips what it missed: the loop never runs two ticks at once to catch up, and never
/// drifts.
class Pacing {
 public:
  /// `rate` [Hz] is held to kSlowestRate..kFastestRate.
  Pacing(Clock& clock, double rate) noexcept;
  /// Sleeps until shortly before the next deadline and spins the rest: a sleep alone ends some tens
  /// of microseconds late.
  Wake Wait() noexcept;
  std::int64_t period() const noexcept { return period_; }  ///< [ns]

 private:
  Clock& clock_;
  std::int64_t period_ = 0;
  std::int64_t spin_ = 0;
  std::int64_t next_ = 0;  ///< deadline [ns]; 0 before the first
};

}  // namespace moontrace
