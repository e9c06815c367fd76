// The guardian of one device (devices/guardian/guardian.h starts it): holds it open beside the
// program, and commands zero force when the program dies or falls silent.

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syslog.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <span>
#include <string>
#include <thread>

#include "devices/guardian/guardian.h"
#include "devices/helper/priority.h"
#include "devices/hid/hid_port.h"

namespace moontrace::guardian_wire {
namespace {

constexpr double kLookWhilePushing = 0.001;  // [s]
constexpr double kLookAtRest = 0.005;        // nothing is late by it: a beat tells its time [s]
constexpr double kRepeatEvery = 0.01;        // [s]
constexpr double kTryFor = 0.03;             // a device that takes no report then is gone [s]
constexpr double kToldAfter = 1;             // shorter silences are the program's to tell [s]

double Now() noexcept {
  using std::chrono::steady_clock;
  return std::chrono::duration<double>(steady_clock::now().time_since_epoch()).count();
}

class Watch {
 public:
  Watch(Shared& shared, HidHandle& device)
      : orders_(shared.orders), program_(shared.program), self_(shared.guardian), device_(device) {}

  /// Until the program has ended.
  void Run() {
    bool taken = false;
    for (;;) {
      const bool pushes = program_.pushes.load(std::memory_order_acquire) != 0;
      const double look = pushes ? kLookWhilePushing : kLookAtRest;
      const Life life = AwaitEnd(program_.life, Now() + look);
      if (life == Life::kEnded) return;
      if (life == Life::kDied || (life == Life::kUnborn && getppid() != orders_.program)) break;
      if (life == Life::kDying) {  // a thread of it may still be writing: again until it is dead
        taken = Send(orders_.releases) || taken;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      } else {
        WatchSilence();
      }
    }
    if (Send(orders_.count) || taken) {
      Tell("Force off: Moontrace could not let go of {}, so its guardian did.");
    }
  }

 private:
  void WatchSilence() {
    const double now = Now();
    const double silent = now - program_.beat.load(std::memory_order_relaxed);
    const bool pushes = program_.pushes.load(std::memory_order_acquire) != 0;
    if (!pushes || silent <= Guardian::kLongestSilence) {
      is_told_ = false;
      return;
    }
    if (now - sent_ >= kRepeatEvery) Send(orders_.releases);
    if (silent > kToldAfter && !is_told_) {
      is_told_ = true;
      Tell("Force off while Moontrace hangs or is stopped: {} is let go of.");
    }
  }

  /// The first `count` reports; again as long as the device takes none. False: it is gone.
  bool Send(std::uint32_t count) {
    const auto reports = std::span(orders_.reports).first(count);
    const double began = Now();
    bool taken = false;
    while (!taken) {
      for (const Report& report : reports) {
        taken = device_.Write(std::span(report.bytes).first(report.size)) || taken;
      }
      sent_ = Now();
      if (sent_ - began > kTryFor) break;
      if (!taken) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    self_.releases.fetch_add(1, std::memory_order_release);
    return taken;
  }

  /// At once on the terminal, where a screen reader says it, and in the system's log.
  void Tell(const char* pattern) const {
    const std::string line = fmt::format(fmt::runtime(pattern), orders_.name.data());
    if (orders_.terminal[0] != '\0') {
      const FileDescriptor terminal(
          open(orders_.terminal.data(), O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
      if (terminal && isatty(terminal.get()) == 1) {
        // It may be in a mode in which a line end alone does not return.
        const std::string text = "\r\n" + line + "\r\n";
        if (write(terminal.get(), text.data(), text.size()) < 0) return;
      }
    }
    syslog(LOG_USER | LOG_WARNING, "%s", line.c_str());
  }

  const Orders& orders_;
  const ProgramPart& program_;
  GuardianPart& self_;
  HidHandle& device_;
  double sent_ = 0;  ///< when zero was last commanded [s]
  bool is_told_ = false;
};

/// It ends with the program and for no other reason.
void BehaveAsGuardian() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGTSTP}) {
    std::signal(signal, SIG_IGN);
  }
  if (chdir("/") != 0) return;  // which always works; a medium can be taken out
}

int Guard(Shared& shared) {
  try {
    HidHandle device = HidHandle::Open(shared.orders.path.data());
    mlockall(MCL_CURRENT | MCL_FUTURE);  // when memory is short it must run all the same
    RunAhead(kLetsGo);
    LifeNote note(shared.guardian.life);
    shared.guardian.phase.store(Phase::kWatching, std::memory_order_release);
    Watch(shared, device).Run();
    note.End();
    return 0;
  } catch (const std::exception& error) {
    std::strncpy(shared.guardian.why.data(), error.what(), shared.guardian.why.size() - 1);
    shared.guardian.phase.store(Phase::kFailed, std::memory_order_release);
    return 4;
  }
}

}  // namespace
}  // namespace moontrace::guardian_wire

int main() {
  using namespace moontrace;
  using guardian_wire::Shared;
  struct ::stat status = {};
  if (fstat(kFirstHelperFile, &status) != 0 ||
      status.st_size != static_cast<::off_t>(sizeof(Shared))) {
    std::fputs("moontrace-guardian is started by moontrace with a device that pushes\n", stderr);
    return 2;
  }
  void* place =
      mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED, kFirstHelperFile, 0);
  if (place == MAP_FAILED) return 4;
  guardian_wire::BehaveAsGuardian();
  return guardian_wire::Guard(*static_cast<Shared*>(place));
}
