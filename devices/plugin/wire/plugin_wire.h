#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "devices/helper/thread_life.h"
#include "devices/moontrace_device.h"
#include "devices/plugin/wire/shared_value.h"

/// What the program and the helper process of a plug-in share: one file in memory of two pages, of
/// which each side writes one and maps the other for reading only. A plug-in that scribbles over
/// its own memory cannot reach the program's.
namespace moontrace::plugin_wire {

inline constexpr std::size_t kPageBytes = 4096;

/// Open files that the helper is started with.
inline constexpr int kMemoryFile = 3;
inline constexpr int kPluginFile = 4;
/// A socket that closes when the other side ends: the helper then lets go and ends too.
inline constexpr int kLifeline = 5;

/// Longest silence of the program before the helper commands zero [s].
inline constexpr double kProgramSilence = 0.02;
/// Longest silence of the helper before the program takes it for hung [s]. Longer than a busy
/// machine keeps a process waiting, shorter than DeviceLimits::silence.
inline constexpr double kHelperSilence = 0.1;

/// The force from now on; putting one is the program's sign of life.
struct Command {
  std::array<double, 3> force{};  ///< frame D [N]
};

struct Reading {
  double time = 0;                   ///< CLOCK_MONOTONIC, which steady_clock reads too [s]
  std::array<double, 3> position{};  ///< frame D [m]
  std::array<double, 3> velocity{};  ///< [m/s]
  std::uint32_t buttons = 0;
  std::uint32_t velocity_known = 0;
  std::uint32_t status = 0;  ///< MOONTRACE_OK or MOONTRACE_NOT_READY
  std::uint32_t reserved = 0;
};

enum class Phase : std::uint32_t {
  kStarting,
  kRunning,
  kFailed,  ///< it could not be loaded or opened; `text` says why
  kLost,    ///< it ran and then failed; `text` says why
};

/// Written by the program.
struct ProgramPage {
  LifeWord life;  ///< of a thread that lives as long as the helper is needed
  SharedValue<Command> command;
};

/// Written by the helper. `description` and `text` are complete before `phase` announces them.
struct HelperPage {
  std::atomic<Phase> phase{Phase::kStarting};
  std::atomic<std::uint64_t> beats{0};  ///< rounds of reading and writing that are complete
  SharedValue<Reading> reading;
  moontrace_description description{};
  std::array<char, 256> text{};
};

static_assert(sizeof(ProgramPage) <= kPageBytes && sizeof(HelperPage) <= kPageBytes);
static_assert(std::atomic<Phase>::is_always_lock_free, "valid across processes");

}  // namespace moontrace::plugin_wire
