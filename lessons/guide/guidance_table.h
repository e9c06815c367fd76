#pragma once

#include <array>
#include <string>
#include <string_view>

#include "lessons/course/course.h"
#include "lessons/course/guidance_mode.h"
#include "lessons/guide/fading.h"

namespace moontrace {

/// What a mode does at a help level. Lengths that scale with letters are in groove widths.
struct GuidanceGains {
  double stiffness = 0;         ///< [N/m]
  double damping = 0;           ///< towards and away from the target [N s/m]
  double dead_zone_widths = 0;  ///< of kCorridor, half its width [groove widths]
  double cap = 1.5;             ///< greatest force [N]
  double bead_speed = 0.02;     ///< along the stroke, and from one to the next [m/s]
  double leash_widths = 1;      ///< the bead waits for a tip farther away [groove widths]
  double cue_amplitude = 0;     ///< of kCorridor's vibration [N]
};

/// Help 0-10 -> gains for every mode, and the parameters of fading, from `lessons/guidance.toml`
/// (the numbers are ours).
class GuidanceTable {
 public:
  static constexpr double kHardCap = 3;  ///< no table may give more [N]

  /// Throws InputError: file:line:column, cause, nearest key.
  static GuidanceTable Load(const std::string& path);
  /// The same from memory; `name` stands in messages.
  static GuidanceTable Parse(std::string_view text, const std::string& name);
  /// Of the file that comes with the program; LackError where it is missing.
  static GuidanceTable Shipped();

  /// Help between whole levels is interpolated; 0 (and NaN) is no push at all, more
  /// than 10 is 10.
  GuidanceGains GainsOf(GuidanceMode mode, double help) const;
  /// Parameters of all fading rules; the kind in it is not used.
  const FadeRule& fade() const { return fade_; }

 private:
  using Levels = std::array<GuidanceGains, kMostHelp + 1>;
  std::array<Levels, kGuidanceModeCount> levels_{};  ///< [mode][help]
  FadeRule fade_;
};

/// The rule that a course names, with the shipped parameters (read once, then kept). Throws
/// InputError for a name that is no rule's, LackError where the shipped file is missing.
FadeRule FadeRuleNamed(const FadeSettings& settings);

}  // namespace moontrace
