#include "devices/plugin/plugin_process.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <new>
#include <system_error>

#include "devices/core/device_error.h"
#include "devices/plugin/trusted_file.h"

namespace moontrace {

using namespace plugin_wire;

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kWatchEvery = 5;  // [ms]
constexpr auto kLongestOpening = std::chrono::seconds(10);
constexpr auto kLongestClosing = std::chrono::milliseconds(500);
constexpr std::size_t kMemoryBytes = 2 * kPageBytes;

[[noreturn]] void Fail(const char* what) {
  throw DeviceError(
      fmt::format("the helper of a plug-in cannot be started: {}: {}", what, std::strerror(errno)));
}

/// A copy beyond the numbers that the helper is started with, so that none is overwritten.
FileDescriptor Aside(const FileDescriptor& fd) {
  return FileDescriptor(fcntl(fd.get(), F_DUPFD_CLOEXEC, kLifeline + 1));
}

/// What the helper is started with: its files, default signals, and a process group of its own, so
/// that Ctrl-C or Ctrl-Z stops the program and leaves the helper to command zero.
class SpawnSettings {
 public:
  SpawnSettings() {
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    sigset_t signals;
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&attributes, &signals);
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes, &signals);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(
        &attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
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

std::string InWords(int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("crashed (signal {}, {})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  }
  return fmt::format("ended its process (code {})", WEXITSTATUS(status));
}

/// Foreign text as part of one line.
std::string Cleaned(const std::array<char, 256>& text) {
  std::string line;
  for (const char c : text) {
    if (c == '\0') break;
    const auto byte = static_cast<unsigned char>(c);
    line += byte < 0x20 || byte == 0x7f ? '?' : c;
  }
  return line;
}

}  // namespace

void PluginProcess::Unmap::operator()(void* memory) const noexcept { munmap(memory, kMemoryBytes); }

void PluginProcess::ShareMemory() {
  memory_file_ = FileDescriptor(memfd_create("moontrace-plugin", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  // Sealed, since touching memory of a file that was cut short kills the process.
  if (!memory_file_ || ftruncate(memory_file_.get(), kMemoryBytes) != 0 ||
      fcntl(memory_file_.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) != 0) {
    Fail("shared memory");
  }
  void* place =
      mmap(nullptr, kMemoryBytes, PROT_READ | PROT_WRITE, MAP_SHARED, memory_file_.get(), 0);
  if (place == MAP_FAILED) Fail("shared memory");
  memory_.reset(place);
  auto* helper_place = static_cast<std::byte*>(place) + kPageBytes;
  program_ = new (place) ProgramPage;
  helper_ = new (helper_place) HelperPage;
  if (mprotect(helper_place, kPageBytes, PROT_READ) != 0) Fail("shared memory");
  // The tick must not wait for memory that is paged in late; a failure only costs time.
  mlock(place, kMemoryBytes);
}

void PluginProcess::Start(const std::string& host, const FileDescriptor& plugin,
                          const FileDescriptor& lifeline) {
  const FileDescriptor memory = Aside(memory_file_);
  const FileDescriptor file = Aside(plugin);
  const FileDescriptor line = Aside(lifeline);
  if (!memory || !file || !line) Fail("open files");
  SpawnSettings settings;
  posix_spawn_file_actions_adddup2(&settings.actions, memory.get(), kMemoryFile);
  posix_spawn_file_actions_adddup2(&settings.actions, file.get(), kPluginFile);
  posix_spawn_file_actions_adddup2(&settings.actions, line.get(), kLifeline);
  std::string name = "moontrace-plugin-host";
  char* arguments[] = {name.data(), nullptr};
  errno =
      posix_spawn(&pid_, host.c_str(), &settings.actions, &settings.attributes, arguments, environ);
  if (errno != 0) {
    pid_ = -1;
    Fail(host.c_str());
  }
}

PluginProcess::PluginProcess(const std::string& host, const std::string& path) {
  const FileDescriptor plugin = OpenTrusted(path);
  ShareMemory();
  int ends[2] = {-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) Fail("socket");
  lifeline_ = FileDescriptor(ends[0]);
  {
    const FileDescriptor far_end(ends[1]);
    Start(host, plugin, far_end);
  }
  try {
    AwaitOpening(path);
    watcher_ = std::thread([this] { Watch(); });
  } catch (...) {
    if (pid_ > 0) Reap();
    throw;
  }
}

PluginProcess::~PluginProcess() {
  closing_.store(true);
  shutdown(lifeline_.get(), SHUT_WR);
  watcher_.join();
}

bool PluginProcess::HasEnded(int milliseconds) const noexcept {
  pollfd lifeline = {lifeline_.get(), POLLIN, 0};
  return poll(&lifeline, 1, milliseconds) > 0;
}

int PluginProcess::Reap() noexcept {
  // It may live on with its end of the lifeline closed; if it has ended, this does no harm.
  kill(pid_, SIGKILL);
  int status = 0;
  // Not for ever: a driver may block the process within the kernel.
  for (int tries = 0; tries < 1000 && waitpid(pid_, &status, WNOHANG) == 0; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  pid_ = -1;
  return status;
}

void PluginProcess::AwaitOpening(const std::string& path) {
  const auto until = Clock::now() + kLongestOpening;
  while (Clock::now() < until) {
    const bool ended = HasEnded(kWatchEvery);
    const Phase phase = helper_->phase.load(std::memory_order_acquire);
    if (phase == Phase::kRunning && !ended) return;
    if (phase == Phase::kFailed) {
      throw DeviceError(fmt::format("plug-in {}: {}", path, Cleaned(helper_->text)));
    }
    if (ended) {
      throw DeviceError(fmt::format("plug-in {}: {} while its device was opened: mend it", path,
                                    InWords(Reap())));
    }
  }
  throw DeviceError(
      fmt::format("plug-in {}: opening its device takes longer than 10 s: mend the plug-in", path));
}

void PluginProcess::Watch() {
  std::uint64_t beats = 0;
  Clock::time_point heard = Clock::now();
  Clock::time_point closing = Clock::time_point::max();
  bool hangs = false;
  while (!HasEnded(kWatchEvery)) {
    const Clock::time_point now = Clock::now();
    const std::uint64_t newest = helper_->beats.load(std::memory_order_acquire);
    if (newest != beats) heard = now;
    beats = newest;
    if (closing_.load() && closing == Clock::time_point::max()) closing = now;
    hangs = !closing_.load() && now - heard > std::chrono::duration<double>(kHelperSilence);
    const bool too_slow = closing_.load() && now - closing > kLongestClosing;
    if (hangs || too_slow) break;
  }
  lost_.store(true, std::memory_order_relaxed);
  const int status = Reap();
  ended_how_ = hangs ? fmt::format("hung for {} s", kHelperSilence) : InWords(status);
  is_over_.store(true, std::memory_order_release);
}

std::string PluginProcess::HowItEnded() const {
  if (helper_->phase.load(std::memory_order_acquire) == Phase::kLost) {
    return Cleaned(helper_->text);
  }
  const auto until = Clock::now() + std::chrono::seconds(1);
  while (lost_.load(std::memory_order_relaxed) && Clock::now() < until) {
    if (is_over_.load(std::memory_order_acquire)) return ended_how_;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return {};
}

std::string PluginHostPath() {
  std::error_code ignored;
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  const std::filesystem::path installed =
      program.parent_path() / MOONTRACE_LIBEXEC / "moontrace-plugin-host";
  if (std::filesystem::exists(installed, ignored)) return installed.string();
  return MOONTRACE_PLUGIN_HOST;
}

}  // namespace moontrace
