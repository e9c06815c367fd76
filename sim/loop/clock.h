#pragma once

#include <cstdint>

namespace moontrace {

/// Where the loop's time comes from, so that tests can bring their own.
class Clock {
 public:
  virtual ~Clock() = default;
  /// [ns], never falling.
  virtual std::int64_t Now() noexcept = 0;
  /// Returns at `time` [ns] or later; at once if it is past.
  virtual void SleepUntil(std::int64_t time) noexcept = 0;
};

/// The system's monotonic clock. Reading it is no system call (vDSO); sleeping is one.
class SteadyClock final : public Clock {
 public:
  std::int64_t Now() noexcept override;
  void SleepUntil(std::int64_t time) noexcept override;
};

}  // namespace moontrace
