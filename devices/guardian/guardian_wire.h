#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "devices/helper/thread_life.h"

/// What the program and a device's guardian share: one file in memory, of which each side writes
/// its own part.
namespace moontrace::guardian_wire {

inline constexpr std::size_t kMostReports = 16;
inline constexpr std::size_t kMostBytes = 128;

/// With its number in byte 0, as HidHandle::Write takes it.
struct Report {
  std::uint32_t size = 0;
  std::array<std::uint8_t, kMostBytes> bytes{};
};

/// What the guardian is for; complete before it is started.
struct Orders {
  std::array<char, 256> path{};      ///< of the device
  std::array<char, 64> name{};       ///< of the device, for people
  std::array<char, 128> terminal{};  ///< where people read the program's errors; empty: nowhere
  std::int32_t program = 0;          ///< the process that is guarded against
  std::uint32_t releases = 0;        ///< the first so many of `reports` command zero force
  std::uint32_t count = 0;           ///< of `reports`; what follows the releases ends the device
  std::array<Report, kMostReports> reports{};
};
static_assert(std::is_trivially_copyable_v<Orders>);

/// Written by the thread of the program that writes to the device.
struct ProgramPart {
  LifeWord life;                         ///< of that thread
  std::atomic<std::uint32_t> pushes{0};  ///< 1 while a force may be on
  std::atomic<double> beat{0};           ///< when it last had a fresh force, steady clock [s]
};

enum class Phase : std::uint32_t { kStarting, kWatching, kFailed };

/// Written by the guardian. `why` is complete before `phase` announces it.
struct GuardianPart {
  LifeWord life;
  std::atomic<Phase> phase{Phase::kStarting};
  std::atomic<std::uint64_t> releases{0};  ///< how often it has commanded zero
  std::array<char, 512> why{};             ///< of kFailed
};

struct Shared {
  Orders orders;
  alignas(64) ProgramPart program;
  alignas(64) GuardianPart guardian;
};
static_assert(std::atomic<Phase>::is_always_lock_free && std::atomic<double>::is_always_lock_free,
              "valid across processes");

}  // namespace moontrace::guardian_wire
