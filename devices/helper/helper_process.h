#pragma once

#include <sys/types.h>

#include <cstddef>
#include <span>
#include <string>

#include "textures/base/file_descriptor.h"

namespace moontrace {

/// Memory that is shared with a helper process, named by an open file; zeros at first.
class SharedMemory {
 public:
  /// `name` is seen in /proc only. Throws DeviceError where the system refuses.
  SharedMemory(const char* name, std::size_t bytes);
  ~SharedMemory();
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  std::byte* data() const noexcept { return data_; }
  int file() const noexcept { return file_.get(); }

 private:
  FileDescriptor file_;
  std::byte* data_ = nullptr;
  std::size_t bytes_;
};

/// The first of the open files that a helper is started with.
inline constexpr int kFirstHelperFile = 3;

/// Where a helper program is: ../libexec beside the installed program, else where it was built.
std::string HelperPath(const std::string& name);

/// kErrors: what the helper prints comes out as errors of the program. kNothing: it keeps none of
/// the program's terminal, pipes and files open.
enum class HelperOutput { kErrors, kNothing };

/// Starts a helper program with the open `files` as its numbers 3, 4 and so on, with nothing to
/// read, default signals and a session of its own, so that Ctrl-C or Ctrl-Z of the terminal stop
/// the program and leave the helper to command zero. Safe in a program of many threads: nothing of
/// ours runs between fork and exec. Throws DeviceError.
::pid_t StartHelper(const std::string& path, std::span<const int> files, HelperOutput output);

/// Collects a helper that has ended or does so within `seconds`: its status, or -1 if it goes on.
int Collect(::pid_t helper, double seconds) noexcept;

}  // namespace moontrace
