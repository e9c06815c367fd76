// push_device PROFILES NAME [segv|abort|kill|stop TICKS]: opens a device as `--device NAME` does
// and pushes, with another force in each tick of a millisecond, until it is killed; or after so
// many ticks prints when [s] and crashes, kills or stops itself. Prints "pushing" once it does. It
// has as much memory as the program, which the system takes apart when it dies.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <glm/vec3.hpp>
#include <string>
#include <thread>
#include <vector>

#include "devices/catalogue/catalogue.h"
#include "devices/helper/priority.h"

namespace {

using namespace moontrace;

double Now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Ends in that way; from "stop" it may come back.
void End(const std::string& how) {
  std::printf("%.6f\n", Now());
  std::fflush(stdout);
  volatile int* volatile nowhere = nullptr;
  if (how == "segv") *nowhere = 1;
  if (how == "kill") kill(getpid(), SIGKILL);
  if (how == "stop") {
    kill(getpid(), SIGSTOP);
    return;
  }
  std::abort();
}

int PushForEver(Device& device, const std::string& end, int end_at) {
  constexpr int kPushing = 20;  // [ticks]
  RunAhead(40);                 // as sim/loop does
  auto next = std::chrono::steady_clock::now();
  int pushed = 0;
  for (long tick = 0;; ++tick) {
    DeviceState state;
    const DeviceStatus status = device.Read(state);
    if (status == DeviceStatus::kLost) return 1;
    const bool is_ready = status != DeviceStatus::kNotReady;
    const double size = 0.4 + 0.1 * std::sin(0.1 * static_cast<double>(tick));
    device.Write(is_ready ? glm::dvec3(size, -size, 0) : glm::dvec3(0, 0, 0));
    pushed += is_ready ? 1 : 0;
    if (is_ready && pushed == kPushing) {
      std::puts("pushing");
      std::fflush(stdout);
    }
    if (!end.empty() && is_ready && pushed == end_at) End(end);
    // ticks that came late are left out: in a burst the device would hear of none
    next = std::max(next + std::chrono::milliseconds(1), std::chrono::steady_clock::now());
    std::this_thread::sleep_until(next);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 5) return 2;
  const std::string end = argc == 5 ? argv[3] : "";
  const int end_at = argc == 5 ? std::atoi(argv[4]) : 0;
  const std::vector<char> memory(std::size_t{64} << 20, 1);
  try {
    DeviceRequest request;
    request.name = argv[2];
    return PushForEver(*OpenDevice(request, argv[1]), end, end_at) + memory.front() - 1;
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
}
