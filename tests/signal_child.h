#pragma once

#include <sys/types.h>

#include <csignal>

namespace moontrace {

/// kill for a process that a test has started; its result. Where that start failed, `child` is -1,
/// and kill would end every process of the machine.
inline int SignalChild(pid_t child, int signal) { return child > 0 ? kill(child, signal) : -1; }

}  // namespace moontrace
