#include "devices/hid/pid_setup.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <thread>

#include "devices/core/device_error.h"

namespace moontrace {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr int kLoadTries = 60;  // as the kernel's own driver
constexpr milliseconds kBetweenTries(2);
constexpr milliseconds kStateWait(500);  // not every device reports its state
constexpr milliseconds kDrainTime(20);
constexpr int kLateReports = 100;  // read after the time is over; a queue holds fewer

[[noreturn]] void Fail(const char* what) {
  throw DeviceError(fmt::format("the joystick {}: plug it in again", what));
}

class Setup {
 public:
  Setup(HidHandle& handle, const PidLayout& layout) : handle_(handle), layout_(layout) {}

  PidSetup Run() {
    Command(pid::kReset);
    Command(pid::kEnable);
    if (layout_.gain.report.IsThere()) Send(EncodeDeviceGain(layout_));
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (layout_.motors[axis]) out_.blocks[axis] = Create(static_cast<int>(axis));
    }
    SwitchAutocentreOff();
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const int block = out_.blocks[axis];
      if (block == 0) continue;
      Send(EncodeSetEffect(layout_, block, static_cast<int>(axis), kPidDuration));
      Send(EncodeConstantForce(layout_, block, 0));
      Send(EncodeOperation(layout_, block, pid::kStart));
    }
    ReadStates(kDrainTime, [] { return false; });
    return out_;
  }

 private:
  void Send(const HidReport& report) {
    if (!handle_.Write(report.span())) Fail("does not take reports");
  }

  void Command(HidUsage command) {
    if (layout_.control.command.Offers(command)) Send(EncodeControl(layout_, command));
  }

  /// Asks for an effect block; a device that allocates none gets a number of ours.
  int Create(int axis) {
    if (!layout_.create.report.IsThere()) return axis + 1;
    if (!handle_.SendFeature(EncodeCreateEffect(layout_).span())) Fail("refuses a constant force");
    for (int i = 0; i < kLoadTries; ++i) {
      HidReport answer;
      answer.bytes[0] = layout_.load.report.id;
      const std::span<std::uint8_t> bytes(answer.bytes.data(), layout_.load.report.bytes);
      const int n = handle_.GetFeature(bytes);
      if (n < 0) Fail("does not answer");
      const PidBlockLoad load = DecodeBlockLoad(layout_, bytes.first(static_cast<std::size_t>(n)));
      using Status = PidBlockLoad::Status;
      if (load.status == Status::kSuccess && load.block > 0) return load.block;
      if (load.status == Status::kFull) Fail("has no room for an effect");
      if (load.status == Status::kError) Fail("failed to load an effect");
      std::this_thread::sleep_for(kBetweenTries);
    }
    Fail("does not load an effect");
  }

  /// Reads input reports for `time`, or until `done`; keeps the newest state. What has arrived by
  /// then is read in any case: on a busy machine this thread may sleep through the whole time.
  void ReadStates(milliseconds time, const std::function<bool()>& done) {
    const auto end = Clock::now() + time;
    int late = 0;
    while (!done()) {
      const auto left = std::chrono::duration_cast<milliseconds>(end - Clock::now()).count();
      if (left <= 0 && ++late > kLateReports) return;
      HidReport report;
      const int n = handle_.Read(report.bytes, static_cast<int>(std::max<std::int64_t>(left, 0)));
      if (n < 0) Fail("is gone");
      if (n == 0 && left <= 0) return;
      const HidReportId& state = layout_.state.report;
      if (!state.IsThere() || report.bytes[0] != state.id ||
          static_cast<std::size_t>(n) < state.bytes) {
        continue;
      }
      report.size = static_cast<std::uint16_t>(n);
      out_.state = DecodeState(layout_, report.span());
    }
  }

  /// PID has no report for it. A firmware with a centring spring of its own keeps it as an effect
  /// in the lowest block, so the first block it hands out is the next (the kernel's driver goes by
  /// the same sign): that effect is stopped, and read back where state reports name the block.
  void SwitchAutocentreOff() {
    const int first = out_.blocks[0] != 0 ? out_.blocks[0] : out_.blocks[1];
    const auto least = static_cast<int>(layout_.load.block.least);
    if (!layout_.create.report.IsThere() || least < 1 || first != least + 1) {
      return;  // nothing to switch off, and nothing that a person could do about it
    }
    Send(EncodeOperation(layout_, least, pid::kStop));
    if (!layout_.state.block.IsThere() || !layout_.state.playing.IsThere()) {
      out_.autocentre = "The stick's centring spring was switched off; it cannot be read back.";
      return;
    }
    out_.state.block = 0;
    ReadStates(kStateWait, [&] { return out_.state.block == least && !out_.state.is_playing; });
    const bool is_off = out_.state.block == least && !out_.state.is_playing;
    out_.autocentre = is_off
                          ? "The stick's centring spring is off, read back."
                          : "The stick's centring spring was switched off; it did not confirm it.";
  }

  HidHandle& handle_;
  const PidLayout& layout_;
  PidSetup out_;
};

}  // namespace

PidSetup SetUpPid(HidHandle& handle, const PidLayout& layout) {
  return Setup(handle, layout).Run();
}

}  // namespace moontrace
