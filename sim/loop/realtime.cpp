#include "sim/loop/realtime.h"

#include <fmt/core.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include <cerrno>
#include <system_error>

namespace moontrace {

namespace {

/// Below the kernel's own threads for interrupts (50), so that USB is served first.
constexpr int kPriority = 40;

std::string Reason(int error) { return std::generic_category().message(error); }

}  // namespace

std::string AskForPriority(int above) {
  // sleeps end at their time, not up to 50 us later; real-time threads have this anyway
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
  sched_param parameters{};
  parameters.sched_priority = kPriority + above;
  const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
  if (error == 0) return {};
  return fmt::format(
      "no real-time priority ({}): allow it by a line \"USER - rtprio {}\" in "
      "/etc/security/limits.d/",
      Reason(error), kPriority + 10);
}

MemoryLock::MemoryLock() {
  // Future memory only where there is no limit: else an allocation beyond it would fail later.
  rlimit limit{};
  const bool unlimited = getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY;
  if (mlockall(unlimited ? MCL_CURRENT | MCL_FUTURE : MCL_CURRENT) != 0) {
    problem_ = fmt::format("memory is not locked ({})", Reason(errno));
  }
}

MemoryLock::~MemoryLock() { munlockall(); }

}  // namespace moontrace
