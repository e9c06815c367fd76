#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace moontrace {

/// Kinds of guiding push (virtual fixtures), see guidance.h.
enum class GuidanceMode : std::uint8_t {
  kOff,
  kAttract,  ///< towards the stroke, outside a dead zone
  kRail,     ///< the same, stiff and without a dead zone
  kBead,     ///< a bead on the path draws the tip, and waits for it
  kAmplify,  ///< away from the stroke: error amplification
  kCorridor  ///< a cue beyond the corridor's edge, without a net force
};

inline constexpr std::size_t kGuidanceModeCount = 6;

/// "off", "attract", "rail", "bead", "amplify", "corridor".
std::string_view NameOf(GuidanceMode mode);
std::optional<GuidanceMode> GuidanceModeOf(std::string_view name);
inline constexpr const char* kGuidanceModes = "off, attract, rail, bead, amplify, corridor";

}  // namespace moontrace
