// The helper process in which a plug-in device runs (devices/plugin/plugin_device.h starts it):
// reads and writes the device at its rate and is its guardian: it lets go at once when the program
// is silent for 20 ms or dies, as soon as the plug-in's own call returns, and ends with it.

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>

#include "devices/helper/priority.h"
#include "devices/plugin/wire/plugin_wire.h"

namespace moontrace::plugin_wire {
namespace {

constexpr double kPaceTime = 0.5;      // over which a plug-in's pace is told [s]
constexpr double kSlowest = 2;         // of its own periods, in the mean
constexpr double kLeastSlow = 0.0005;  // what is sooner is no matter [s]

std::atomic<bool> asked_to_end{false};

extern "C" void AskToEnd(int) { asked_to_end.store(true); }

double Now() noexcept {
  using std::chrono::steady_clock;
  return std::chrono::duration<double>(steady_clock::now().time_since_epoch()).count();
}

void* MapPage(int page, int protection) {
  void* place = mmap(nullptr, kPageBytes, protection, MAP_SHARED, kMemoryFile,
                     static_cast<::off_t>(page) * static_cast<::off_t>(kPageBytes));
  return place == MAP_FAILED ? nullptr : place;
}

void Report(HelperPage& page, Phase phase, const std::string& text) {
  const std::size_t size = std::min(text.size(), page.text.size() - 1);
  std::memcpy(page.text.data(), text.data(), size);
  page.text[size] = '\0';
  page.phase.store(phase, std::memory_order_release);
}

/// Ends the process soon after the program has, even if the plug-in hangs.
void WatchLifeline() {
  pollfd lifeline = {kLifeline, POLLIN, 0};
  while (poll(&lifeline, 1, -1) < 0) {
  }
  asked_to_end.store(true);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  kill(0, SIGKILL);  // and with it what the plug-in has started
}

const moontrace_device& LoadPlugin() {
  // The open file that was checked, not its name, which may mean another by now.
  void* library =
      dlopen(fmt::format("/proc/self/fd/{}", kPluginFile).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    throw std::runtime_error(fmt::format("cannot be loaded: {}", dlerror()));
  }
  void* symbol = dlsym(library, "moontrace_device_entry");
  if (symbol == nullptr) {
    throw std::runtime_error(
        "defines no moontrace_device_entry: write one as devices/plugins/template.c does");
  }
  const auto entry = reinterpret_cast<const moontrace_device* (*)()>(symbol);
  const moontrace_device* device = entry();
  if (device == nullptr || device->version != MOONTRACE_DEVICE_VERSION) {
    throw std::runtime_error(fmt::format(
        "is made for version {} of moontrace_device.h, this program takes {}: build it anew",
        device == nullptr ? 0 : device->version, MOONTRACE_DEVICE_VERSION));
  }
  if (device->size < sizeof(moontrace_device)) {
    throw std::runtime_error(
        fmt::format("gives {} as the size of its struct moontrace_device, of {} bytes or more: set "
                    "it to sizeof(struct moontrace_device)",
                    device->size, sizeof(moontrace_device)));
  }
  if (device->describe == nullptr || device->open == nullptr || device->read == nullptr ||
      device->write == nullptr || device->close == nullptr) {
    throw std::runtime_error("lacks a function: all five of struct moontrace_device are needed");
  }
  return *device;
}

bool AllFinite(const double* values) noexcept {
  return std::isfinite(values[0]) && std::isfinite(values[1]) && std::isfinite(values[2]);
}

/// A plug-in's device, opened; closed with zero force at the end.
class OpenDevice {
 public:
  OpenDevice(const moontrace_device& device, HelperPage& page, const ProgramPage& program)
      : device_(device), page_(page), program_(program) {
    moontrace_description description = {};
    description.size = sizeof description;
    if (device_.describe(&description) != 0) {
      throw std::runtime_error("does not describe its device: describe did not return 0");
    }
    if (!(description.rate >= 100 && description.rate <= 10000)) {
      throw std::runtime_error("rate is not from 100 to 10000 Hz: correct it in describe");
    }
    char error[200] = {};
    self_ = device_.open(error, sizeof error);
    error[sizeof error - 1] = '\0';
    if (self_ == nullptr) {
      throw std::runtime_error(error[0] == '\0' ? "cannot open its device and does not say why"
                                                : error);
    }
    page_.description = description;
  }
  OpenDevice(const OpenDevice&) = delete;
  OpenDevice& operator=(const OpenDevice&) = delete;
  ~OpenDevice() {
    const double zero[3] = {0, 0, 0};
    device_.write(self_, zero);
    device_.close(self_);
  }

  /// Reads and writes once a period until asked to end. Throws std::runtime_error: lost.
  void Run() {
    const double period = 1 / page_.description.rate;
    double next = Now();
    while (!asked_to_end.load(std::memory_order_relaxed)) {
      const double began = Now();
      ReadOnce();
      WriteOnce();
      WatchPace(began, Now(), period);
      page_.beats.fetch_add(1, std::memory_order_release);
      next = std::max(next + period, Now());  // what was missed is not made up for
      WaitUntil(next);
    }
  }

 private:
  void ReadOnce() {
    moontrace_reading got = {};
    got.size = sizeof got;
    const int status = device_.read(self_, &got);
    if (status == MOONTRACE_NO_NEW_DATA) return;
    if (status != MOONTRACE_OK && status != MOONTRACE_NOT_READY) {
      throw std::runtime_error("lost its device");
    }
    const bool has_velocity = status == MOONTRACE_OK && got.velocity_known != 0;
    if ((status == MOONTRACE_OK && !AllFinite(got.position)) ||
        (has_velocity && !AllFinite(got.velocity))) {
      throw std::runtime_error("gave a position or velocity that is no number");
    }
    Reading reading;
    reading.time = Now();
    std::copy_n(got.position, 3, reading.position.begin());
    std::copy_n(got.velocity, 3, reading.velocity.begin());
    reading.buttons = got.buttons;
    reading.velocity_known = has_velocity ? 1 : 0;
    reading.status = static_cast<std::uint32_t>(status);
    page_.reading.Put(reading);
  }

  void WriteOnce() {
    const double now = Now();
    if (program_.command.Take(command_, seen_)) heard_ = now;
    const bool silent = now - heard_ >= kProgramSilence;
    double force[3] = {0, 0, 0};
    for (std::size_t i = 0; i < 3 && !silent && AllFinite(command_.force.data()); ++i) {
      const double peak = page_.description.peak_force;
      const bool pushes = ((page_.description.pushes >> i) & 1u) != 0;
      if (pushes) force[i] = std::clamp(command_.force[i], -peak, peak);
    }
    pushes_ = force[0] != 0 || force[1] != 0 || force[2] != 0;
    const int status = device_.write(self_, force);
    if (status != MOONTRACE_OK && status != MOONTRACE_NOT_READY) {
      throw std::runtime_error("lost its device");
    }
  }

  /// A plug-in whose calls take far longer than the period it promises renders forces that are not
  /// stable, and lets go late. Time outside of its calls, on a busy machine say, does not count.
  void WatchPace(double began, double ended, double period) {
    if (rounds_ == 0) pace_since_ = began;
    ++rounds_;
    in_calls_ += ended - began;
    if (ended - pace_since_ < kPaceTime) return;
    const double mean = in_calls_ / rounds_;
    if (mean > std::max(kSlowest * period, kLeastSlow)) {
      throw std::runtime_error(
          fmt::format("reads and writes {:.0f} times a second, not {:.0f} as it describes: correct "
                      "the rate in describe, or make read and write return sooner",
                      1 / mean, 1 / period));
    }
    rounds_ = 0;
    in_calls_ = 0;
  }

  /// Until a round is due. The program's death ends it at once; its silence is answered when it is
  /// long enough, however slow the device's rounds are.
  void WaitUntil(double next) {
    while (!asked_to_end.load(std::memory_order_relaxed)) {
      const double until = pushes_ ? std::min(next, heard_ + kProgramSilence) : next;
      const Life life = AwaitEnd(program_.life, until);
      if (life == Life::kDying || life == Life::kDied) asked_to_end.store(true);
      if (Now() >= next) return;
      if (pushes_ && Now() >= heard_ + kProgramSilence) WriteOnce();
    }
  }

  const moontrace_device& device_;
  HelperPage& page_;
  const ProgramPage& program_;
  void* self_ = nullptr;
  Command command_;
  std::uint64_t seen_ = 0;
  double heard_ = -1;  ///< when the newest command came [s]
  bool pushes_ = false;
  double pace_since_ = 0, in_calls_ = 0;  ///< since when the pace is watched, and of it [s]
  int rounds_ = 0;
};

void BehaveAsHelper() {
  struct sigaction action = {};
  action.sa_handler = AskToEnd;
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGINT, &action, nullptr);
  std::signal(SIGHUP, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  RunAhead(kLetsGo);  // where not, the device is late as the machine is busy
}

void RunHelper(const ProgramPage& program, HelperPage& page) {
  try {
    const moontrace_device& plugin = LoadPlugin();
    OpenDevice device(plugin, page, program);
    page.phase.store(Phase::kRunning, std::memory_order_release);
    try {
      device.Run();
    } catch (const std::runtime_error& error) {
      Report(page, Phase::kLost, error.what());  // at once: the device's closing may take its time
    }
  } catch (const std::runtime_error& error) {
    Report(page, Phase::kFailed, error.what());
  }
}

}  // namespace
}  // namespace moontrace::plugin_wire

int main() {
  using namespace moontrace::plugin_wire;
  struct ::stat status = {};
  if (fstat(kMemoryFile, &status) != 0 || fcntl(kLifeline, F_GETFD) < 0 ||
      status.st_size != static_cast<::off_t>(2 * kPageBytes)) {
    std::fputs("moontrace-plugin-host is started by moontrace --device plugin:PATH\n", stderr);
    return 2;
  }
  const void* program = MapPage(0, PROT_READ);
  void* helper = MapPage(1, PROT_READ | PROT_WRITE);
  if (program == nullptr || helper == nullptr) return 4;
  BehaveAsHelper();
  std::thread(WatchLifeline).detach();
  const auto& page = *static_cast<const ProgramPage*>(program);
  RunHelper(page, *static_cast<HelperPage*>(helper));
  // What the plug-in has started ends too; while the program lives, it sees to that.
  const moontrace::Life life = moontrace::LifeOf(page.life);
  if (life == moontrace::Life::kDying || life == moontrace::Life::kDied) kill(0, SIGKILL);
  return 0;
}
