#include "devices/guardian/guardian.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <new>
#include <string_view>
#include <thread>

#include "devices/core/device_error.h"

namespace moontrace {

using namespace guardian_wire;

namespace {

const char* const kProgram = "moontrace-guardian";
constexpr auto kLongestStart = std::chrono::seconds(10);
constexpr double kLongestEnd = 0.2;   // [s]
constexpr double kLongestKill = 0.1;  // [s]

template <std::size_t n>
void Copy(std::string_view text, std::array<char, n>& to) {
  text.substr(0, n - 1).copy(to.data(), n - 1);
}

/// The terminal that people read, by name, so that the guardian need not hold it open.
std::string Terminal() {
  std::array<char, 128> name{};
  for (const int fd : {STDERR_FILENO, STDOUT_FILENO}) {
    if (ttyname_r(fd, name.data(), name.size()) == 0) return name.data();
  }
  return {};
}

void Add(Orders& orders, const std::vector<std::vector<std::uint8_t>>& reports) {
  for (const auto& bytes : reports) {
    if (orders.count == kMostReports || bytes.size() > kMostBytes) {
      throw DeviceError("it needs more reports to let go than its guardian takes");
    }
    Report& report = orders.reports[orders.count++];
    report.size = static_cast<std::uint32_t>(bytes.size());
    std::ranges::copy(bytes, report.bytes.begin());
  }
}

Orders OrdersFor(const GuardedDevice& device) {
  Orders orders;
  if (device.path.size() >= orders.path.size()) {
    throw DeviceError(fmt::format("{}: its path is too long for a guardian", device.path));
  }
  Copy(device.path, orders.path);
  Copy(device.name, orders.name);
  Copy(Terminal(), orders.terminal);
  orders.program = getpid();
  Add(orders, device.release);
  orders.releases = orders.count;
  Add(orders, device.farewell);
  return orders;
}

}  // namespace

std::string Guardian::WhyNone() {
  if (access(HelperPath(kProgram).c_str(), X_OK) == 0) return {};
  return "its program moontrace-guardian is not there: install Moontrace again";
}

Guardian::Guardian(const GuardedDevice& device)
    : memory_("moontrace-guardian", sizeof(Shared)), shared_(new (memory_.data()) Shared) {
  shared_->orders = OrdersFor(device);
  const int files[] = {memory_.file()};
  process_ = StartHelper(HelperPath(kProgram), files, HelperOutput::kNothing);
  try {
    AwaitWatching(device.name);
  } catch (...) {
    kill(process_, SIGKILL);
    Collect(process_, kLongestKill);
    throw;
  }
}

void Guardian::AwaitWatching(const std::string& name) {
  const auto until = std::chrono::steady_clock::now() + kLongestStart;
  while (std::chrono::steady_clock::now() < until) {
    const Phase phase = shared_->guardian.phase.load(std::memory_order_acquire);
    if (phase == Phase::kWatching) return;
    if (phase == Phase::kFailed) {
      throw DeviceError(fmt::format("no guardian: {}", shared_->guardian.why.data()));
    }
    if (Collect(process_, 0) != -1) {
      throw DeviceError(fmt::format(
          "{}: its guardian ended while it was started: install the program again", name));
    }
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
  throw DeviceError(
      fmt::format("{}: its guardian takes longer than 10 s to start: try again", name));
}

Guardian::~Guardian() {
  if (Collect(process_, kLongestEnd) != -1) return;
  kill(process_, SIGKILL);
  Collect(process_, kLongestKill);
}

}  // namespace moontrace
