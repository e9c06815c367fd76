#include "devices/helper/priority.h"

#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>

namespace moontrace {

void RunAhead(int priority) noexcept {
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
  sched_param parameters{};
  parameters.sched_priority = priority;
  if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0) return;
  rlimit limit{};  // 20 less than a nice value
  if (getrlimit(RLIMIT_NICE, &limit) == 0 && limit.rlim_cur > 20 && limit.rlim_cur <= 40) {
    setpriority(PRIO_PROCESS, 0, 20 - static_cast<int>(limit.rlim_cur));  // of this thread
  }
}

}  // namespace moontrace
