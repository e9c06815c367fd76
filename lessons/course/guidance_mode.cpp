#include "lessons/course/guidance_mode.h"

#include <array>

namespace moontrace {

namespace {

constexpr std::array<std::string_view, 6> kNames = {"off",  "attract", "rail",
                                                    "bead", "amplify", "corridor"};

}  // namespace

std::string_view NameOf(GuidanceMode mode) { return kNames[static_cast<std::size_t>(mode)]; }

std::optional<GuidanceMode> GuidanceModeOf(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] == name) return static_cast<GuidanceMode>(i);
  }
  return std::nullopt;
}

}  // namespace moontrace
