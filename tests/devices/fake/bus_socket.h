#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace moontrace::fake {

/// A bus that processes share: the first that loads the fake hidapi owns it, and each process that
/// it starts (a device's guardian, a program that will be killed) opens devices of that bus through
/// a local socket, one connection for each handle.

/// Environment variable with the socket's path; set by the owner for its children.
inline constexpr const char* kBusVariable = "MOONTRACE_FAKE_BUS";

/// What one call of hidapi carries. Times are of the steady clock [s].
struct Call {
  enum What : std::int32_t { kOpen, kWrite, kRead, kSendFeature, kGetFeature } what = kOpen;
  std::int32_t size = 0;
  double time = 0;  ///< when it was made
  unsigned char data[4096] = {};
};
struct Answer {
  std::int32_t result = -1;
  unsigned char data[4096] = {};
};

/// The owner: what a connection does; `handle` is its own to keep, null at first.
using Serve = void (*)(void*& handle, const Call& call, Answer& answer);
using Hang = void (*)(void* handle);

/// Starts a thread that serves one call after the other, in the order in which the connections were
/// made: what was sent before a process died counts before what its guardian sends. Real-time where
/// it is allowed, since it stands for hardware.
void ServeBus(const std::string& path, Serve serve, Hang hang);

/// A child: a connection, or -1.
int ConnectToBus(const char* path);
/// Makes the call over a connection. False: the owner is gone.
bool CallBus(int connection, const Call& call, Answer& answer);

}  // namespace moontrace::fake
