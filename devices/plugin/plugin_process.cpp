#include "devices/plugin/plugin_process.h"

#include <fmt/core.h>
#include <poll.h>
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
#include <new>

#include "devices/core/device_error.h"
#include "devices/helper/priority.h"
#include "devices/plugin/trusted_file.h"

namespace moontrace {

using namespace plugin_wire;

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kWatchEvery = 5;  // [ms]
constexpr auto kLongestOpening = std::chrono::seconds(10);
constexpr auto kLongestClosing = std::chrono::milliseconds(500);

[[noreturn]] void Fail(const char* what) {
  throw DeviceError(
      fmt::format("the helper of a plug-in cannot be started: {}: {}", what, std::strerror(errno)));
}

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

PluginProcess::PluginProcess(const std::string& host, const std::string& path)
    : memory_("moontrace-plugin", 2 * kPageBytes),
      program_(new (memory_.data()) ProgramPage),
      helper_(new (memory_.data() + kPageBytes) HelperPage) {
  if (mprotect(memory_.data() + kPageBytes, kPageBytes, PROT_READ) != 0) Fail("shared memory");
  const FileDescriptor plugin = OpenTrusted(path);
  int ends[2] = {-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) Fail("socket");
  lifeline_ = FileDescriptor(ends[0]);
  {
    const FileDescriptor far_end(ends[1]);
    const int files[] = {memory_.file(), plugin.get(), far_end.get()};
    pid_ = StartHelper(host, files, HelperOutput::kErrors);
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
  // It may live on with its end of the lifeline closed; if it has ended, this does no harm. With it
  // goes whatever the plug-in has started: the helper leads a group of its own.
  kill(-pid_, SIGKILL);
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
    if (phase == Phase::kLost) {
      HasEnded(static_cast<int>(kLongestClosing.count()));  // it closes its device
      throw DeviceError(fmt::format("plug-in {}: {} as soon as it was opened: mend it", path,
                                    Cleaned(helper_->text)));
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
  // By it the helper knows at once that the program died, and a thread dies when it is run.
  const LifeNote note(program_->life);
  RunAhead(kCarriesForces);
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

}  // namespace moontrace
