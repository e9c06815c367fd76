#include "devices/helper/helper_process.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <thread>
#include <vector>

#include "devices/core/device_error.h"

namespace moontrace {
namespace {

[[noreturn]] void Fail(const std::string& what) {
  throw DeviceError(fmt::format("a helper process of the device cannot be started: {}: {}", what,
                                std::strerror(errno)));
}

class SpawnSettings {
 public:
  explicit SpawnSettings(HelperOutput output) {
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    sigset_t signals;
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&attributes, &signals);
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes, &signals);
    posix_spawnattr_setflags(&attributes,
                             POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSID);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (output == HelperOutput::kNothing) {
      posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    }
    // What a vendor's driver prints is no result of ours.
    posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  }
  ~SpawnSettings() {
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
};

}  // namespace

SharedMemory::SharedMemory(const char* name, std::size_t bytes)
    : file_(memfd_create(name, MFD_CLOEXEC | MFD_ALLOW_SEALING)), bytes_(bytes) {
  // Sealed, since touching memory of a file that was cut short kills the process.
  if (!file_ || ftruncate(file_.get(), static_cast<::off_t>(bytes)) != 0 ||
      fcntl(file_.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) != 0) {
    Fail("shared memory");
  }
  void* place = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file_.get(), 0);
  if (place == MAP_FAILED) Fail("shared memory");
  data_ = static_cast<std::byte*>(place);
  // The tick must not wait for memory that is paged in late; a failure only costs time.
  mlock(place, bytes);
}

SharedMemory::~SharedMemory() { munmap(data_, bytes_); }

std::string HelperPath(const std::string& name) {
  std::error_code ignored;
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  const std::filesystem::path installed = program.parent_path() / MOONTRACE_LIBEXEC / name;
  if (std::filesystem::exists(installed, ignored)) return installed.string();
  return std::string(MOONTRACE_HELPERS) + "/" + name;
}

::pid_t StartHelper(const std::string& path, std::span<const int> files, HelperOutput output) {
  const int end = kFirstHelperFile + static_cast<int>(files.size());
  SpawnSettings settings(output);
  // Copies beyond the numbers that the helper is started with, so that none is overwritten.
  std::vector<FileDescriptor> aside;
  for (std::size_t i = 0; i < files.size(); ++i) {
    aside.emplace_back(fcntl(files[i], F_DUPFD_CLOEXEC, end));
    if (!aside.back()) Fail("open files");
    posix_spawn_file_actions_adddup2(&settings.actions, aside.back().get(),
                                     kFirstHelperFile + static_cast<int>(i));
  }
  posix_spawn_file_actions_addclosefrom_np(&settings.actions, end);
  std::string name = std::filesystem::path(path).filename().string();
  char* arguments[] = {name.data(), nullptr};
  ::pid_t helper = -1;
  errno = posix_spawn(&helper, path.c_str(), &settings.actions, &settings.attributes, arguments,
                      environ);
  if (errno != 0) Fail(path);
  return helper;
}

int Collect(::pid_t helper, double seconds) noexcept {
  for (int tries = 0; tries <= static_cast<int>(seconds * 1e3); ++tries) {
    int status = 0;
    const ::pid_t got = waitpid(helper, &status, WNOHANG);
    if (got == helper) return status;
    if (got < 0 && errno != EINTR) return 0;  // somebody else has collected it
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return -1;
}

}  // namespace moontrace
