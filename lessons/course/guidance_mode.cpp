#include "lessons/course/guidance_mode.h"

#include "textures/base/enum_names.h"

namespace moontrace {

namespace {

constexpr std::string_view NameOfMode(GuidanceMode mode) {
  switch (mode) {
    case GuidanceMode::kOff:
      return "off";
    case GuidanceMode::kAttract:
      return "attract";
    case GuidanceMode::kRail:
      return "rail";
    case GuidanceMode::kBead:
      return "bead";
    case GuidanceMode::kAmplify:
      return "amplify";
    case GuidanceMode::kCorridor:
      return "corridor";
  }
  return {};
}
static_assert(CountNamed(&NameOfMode) == kGuidanceModeCount);

}  // namespace

std::string_view NameOf(GuidanceMode mode) { return NameOfMode(mode); }

std::optional<GuidanceMode> GuidanceModeOf(std::string_view name) {
  return ValueNamed(name, &NameOfMode);
}

}  // namespace moontrace
