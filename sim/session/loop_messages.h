#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/loop/loop.h"
#include "textures/typeset/typeset.h"

/// Sentences of `moontrace loop` and of `trace --device`; see messages.h.
namespace moontrace::say {

namespace help {
inline constexpr const char* kLoop = "lets a text be felt in real time, with any device";
inline constexpr const char* kDefaultText = "the moon is bright";
inline constexpr const char* kLoopText =
    "the text; - reads standard input. Default the model's, else \"the moon is bright\".";
inline constexpr const char* kDevice =
    "what moves the tip: simulated, a name from moontrace devices, plugin:PATH, or mouse with "
    "--view. Default simulated.";
inline constexpr const char* kSeconds =
    "ends after so many seconds. Default: when you say quit, or input has ended.";
inline constexpr const char* kRate = "ticks a second, 250 to 10000. Default 1000.";
inline constexpr const char* kScale =
    "way on the page per way of the device, 0.1 to 10. Default 1: letters in true size. Scaled "
    "work never counts for mastery.";
inline constexpr const char* kLoopPress =
    "press on the page in N, for devices without a third axis and the simulated hand. Default 1.";
inline constexpr const char* kHoldToFeel = "force only while the first button is held.";
}  // namespace help

/// Also of `trace`, which says when.
inline constexpr const char* kPageWentAway =
    "page went away under the hand, faster than a hand follows: hold it by a spring or damping, or "
    "press less.";

/// What is felt; `chosen`: somebody gave it.
std::string OnThePage(std::string_view text, bool chosen);
std::string LoopBegins(std::string_view device);
std::string NotRealtime(std::string_view why);
std::string Scaled(double scale);
std::string SetFor(const PageSpec& page, std::size_t pages);
std::string SofterThanUsual(double share);  ///< of the usual stiffness, below 1
std::string HowToSpeak();
std::string CannotSpeak();
std::string InputEnded();
std::string EndedLost(std::string_view why);

// Where nothing is felt (LiveDevice::felt) nothing is said of force: some events have no sentence.
std::string Event(const LoopEvent& event, bool felt);
/// What safety has done.
std::string Event(SafetyEvent event, bool felt);
/// May happen many times a minute, and asks for nothing: said once, then counted (Repeated).
bool MayRepeat(SafetyEvent event);
/// Behind it all: what was said once, or with gaps, and happened again. Empty: nothing did.
std::string Repeated(const std::array<std::uint64_t, kSafetyEvents>& counts);
/// `why`: Loop::WhyGone.
std::string DeviceLost(std::string_view why);
/// "not_a_number", "jump", ...: the key in JSON.
std::string_view EventName(SafetyEvent event);
/// Of "stop" or "pause", and of "go", that changes nothing.
std::string AlreadyStopped();
std::string NotStopped();
std::string ForceIsBack();  ///< behind motors that were off
std::string LoopSilent();
std::string StillLost(std::string_view why);

std::string NowPage(std::size_t page, std::size_t pages);
std::string NoOtherPage(bool forward, std::size_t pages);
std::string NowSize(double size, std::size_t page, std::size_t pages);
std::string CannotResize(std::string_view why);
std::string SizeStays();
/// `letter` empty: none is near.
/// What the tip feels.
struct Feeling {
  bool touching = false;
  bool has_motors = true;
  bool stopped = false;
  double force = 0;  ///< [N]
};
std::string Where(std::string_view letter, std::size_t line, std::size_t page, std::size_t pages,
                  const Feeling& feeling);
std::string NoMotors();
std::string NoMark();
/// `way_P` from the tip [m]; none: the page has just been turned to.
std::string WayToMark(std::string_view letter, std::size_t page, std::size_t pages,
                      std::optional<glm::dvec2> way_P);

std::string LoopOutcome(double seconds);
std::string Lateness(const LoopReport& report);
std::string SafetyActed(const LoopReport& report);
/// Where nothing is felt.
std::string Touched(double share);
std::string Touched(double share, double mean_force, double peak_force);

std::string NotWithDevice(std::string_view option);
std::string OnlyWithDevice(std::string_view option);
std::string DeviceTime(double seconds);
std::string NothingTraced();
std::string NeverTouched(double seconds);

}  // namespace moontrace::say
