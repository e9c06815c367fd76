#include "lessons/guide/fading.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace moontrace {

namespace {

/// Less help than this is none: a factor below 1 alone would never reach zero.
constexpr double kLeastHelp = 0.05;

constexpr std::array<std::string_view, 4> kNames = {"manual", "linear", "gate", "as-needed"};

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
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] == name) return static_cast<FadeRule::Kind>(i);
  }
  return std::nullopt;
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
