#include "lessons/guide/fading.h"

#include <algorithm>

#include "textures/base/enum_names.h"

namespace moontrace {

namespace {

/// Less help than this is none: a factor below 1 alone would never reach zero.
constexpr double kLeastHelp = 0.05;

constexpr std::string_view NameOf(FadeRule::Kind kind) {
  switch (kind) {
    case FadeRule::Kind::kManual:
      return "manual";
    case FadeRule::Kind::kLinear:
      return "linear";
    case FadeRule::Kind::kGate:
      return "gate";
    case FadeRule::Kind::kAsNeeded:
      return "as-needed";
  }
  return {};
}

FadeState FadeByGate(const FadeRule& rule, FadeState state, bool good) {
  if (!good) {
    state.help += 1;
    state.good_run = 0;
  } else if (++state.good_run >= rule.gate_good) {
    state.help -= 1;
    state.good_run = 0;
  }
  return state;
}

double HelpAsNeeded(const FadeRule& rule, double help, double error_widths) {
  const double error = error_widths > rule.dead_zone ? error_widths - rule.dead_zone : 0;
  const double next = rule.forgetting * help + rule.gain * error;
  return error <= 0 && next < kLeastHelp ? 0 : next;
}

}  // namespace

std::optional<FadeRule::Kind> FadeKindOf(std::string_view name) {
  return ValueNamed(name, &NameOf);
}

FadeState FadeHelp(const FadeRule& rule, FadeState state, double error_widths, bool good) {
  switch (rule.kind) {
    case FadeRule::Kind::kManual:
      break;
    case FadeRule::Kind::kLinear:
      state.help -= rule.linear_step;
      break;
    case FadeRule::Kind::kGate:
      state = FadeByGate(rule, state, good);
      break;
    case FadeRule::Kind::kAsNeeded:
      state.help = HelpAsNeeded(rule, state.help, error_widths);
      break;
  }
  state.help = state.help > 0 ? std::min(state.help, double{kMostHelp}) : 0;
  return state;
}

}  // namespace moontrace
