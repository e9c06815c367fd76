#pragma once

#include <stdexcept>

namespace moontrace {

/// MuJoCo met an error within a call. One line.
class MujocoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs `work`, in which MuJoCo runs, so that an error of MuJoCo's ends `work` there and then:
/// false, and LastMujocoError says what it was. MuJoCo is left by a jump, as by its own binding for
/// Python: so nothing that `work` has on the stack when MuJoCo runs may need a destructor. Handlers
/// of the program and other threads are not touched. No allocation or lock. Not within itself.
template <class Work>
bool RunMujoco(Work& work) noexcept;

/// This thread's, one line; never null.
const char* LastMujocoError() noexcept;

/// As RunMujoco, for work behind a pointer.
bool RunMujocoWork(void (*work)(void*), void* context) noexcept;

template <class Work>
bool RunMujoco(Work& work) noexcept {
  const auto run = [](void* context) { (*static_cast<Work*>(context))(); };
  return RunMujocoWork(run, const_cast<void*>(static_cast<const void*>(&work)));
}

}  // namespace moontrace
