#include "sim/loop/clock.h"

#include <cerrno>
#include <ctime>

namespace moontrace {

namespace {
constexpr std::int64_t kSecond = 1'000'000'000;
}

std::int64_t SteadyClock::Now() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return kSecond * now.tv_sec + now.tv_nsec;
}

void SteadyClock::SleepUntil(std::int64_t time) noexcept {
  timespec until{};
  until.tv_sec = static_cast<time_t>(time / kSecond);
  until.tv_nsec = static_cast<long>(time % kSecond);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

}  // namespace moontrace
