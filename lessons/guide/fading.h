#pragma once

#include <optional>
#include <string_view>

namespace moontrace {

/// Parameters of the fading rules, from `lessons/guidance.toml` (ours; rules after
/// training-and-ux.md 1.3).
struct FadeRule {
  enum class Kind { kManual, kLinear, kGate, kAsNeeded } kind = Kind::kGate;
  double linear_step = 0.5;  ///< help lost with each trial
  int gate_good = 2;         ///< good trials in a row that lower help by one
  double forgetting = 0.8;   ///< f_R of assist-as-needed, < 1
  double gain = 2;           ///< g_R [help per groove width of error]
  double dead_zone = 0.3;    ///< error that counts as none [groove widths]
};

/// Help goes from 0 to this.
inline constexpr int kMostHelp = 10;

/// What fading remembers.
struct FadeState {
  double help = 0;  ///< 0-10
  int good_run = 0;
};

/// The names of the kinds: "manual", "linear", "gate", "as-needed".
inline constexpr const char* kFadeRules = "manual, linear, gate, as-needed";
std::optional<FadeRule::Kind> FadeKindOf(std::string_view name);

/// Help of the next trial after one with this mean error [groove widths] that was good or not.
///
/// - manual: stays.
/// - linear: `linear_step` less each trial, whatever it was.
/// - gate: one less after `gate_good` good trials in a row, one more after a bad one.
/// - as needed: help' = f_R help + g_R e (Emken, Benitez, Reinkensmeyer 2007), e the error beyond
///   the dead zone. The robot forgets: with e = 0 help shrinks, and is 0 once below 0.05.
///
/// Always 0 to 10. An error that is NaN, or below 0, counts as none.
FadeState FadeHelp(const FadeRule& rule, FadeState state, double error_widths, bool good);

}  // namespace moontrace
