#pragma once

#include <string>

#include "lessons/course/guidance_mode.h"

/// Sentences about the guiding push of a trace.
namespace moontrace::say {

/// How strong the push was on average and what it did to the hand.
std::string Guided(GuidanceMode mode, double help, double mean_force, double work);

namespace help {
inline constexpr const char* kGuide =
    "a push on the hand: off, attract, rail, bead, amplify or corridor. Default off.";
inline constexpr const char* kHelpLevel = "how much, 0 (none) to 10. Default 6.";
}  // namespace help

}  // namespace moontrace::say
