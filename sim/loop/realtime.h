#pragma once

#include <string>

namespace moontrace {

/// Asks the system to run the calling thread ahead of all ordinary ones (SCHED_FIFO). `above`
/// raises it over another such thread. Never throws: returns an empty string, or one sentence that
/// says why not and what mends it.
std::string AskForPriority(int above = 0);

/// Keeps the program's memory from being swapped out while it lives, where the system allows that
/// (mlockall).
class MemoryLock {
 public:
  MemoryLock();
  ~MemoryLock();
  MemoryLock(const MemoryLock&) = delete;
  MemoryLock& operator=(const MemoryLock&) = delete;
  /// Empty, or one sentence why not.
  const std::string& problem() const { return problem_; }

 private:
  std::string problem_;
};

}  // namespace moontrace
