#include "sim/loop/button.h"

namespace moontrace {
namespace {

/// A change of `down`, dated from when the contact first moved.
ButtonAction Change(ButtonState& state, bool hold_to_feel) noexcept {
  const double lasted = state.raw_since - state.changed;
  state.down = state.raw;
  state.changed = state.raw_since;
  if (state.down) {
    state.spent = false;
    return ButtonAction::kNone;
  }
  if (!state.spent && lasted < kButtonHeld) {
    if (++state.presses < 2) return ButtonAction::kNone;
    state.presses = 0;
    return ButtonAction::kBookmark;
  }
  const bool waiting = state.presses == 1;  // a short press that a long one followed
  state.presses = 0;
  if (state.spent) return ButtonAction::kNone;
  if (!hold_to_feel) return ButtonAction::kStop;  // held while no tick read it
  return waiting ? ButtonAction::kSay : ButtonAction::kNone;
}

}  // namespace

ButtonAction AdvanceButtons(ButtonState& state, std::uint32_t buttons, double time,
                            bool hold_to_feel) noexcept {
  const bool first = (buttons & 1U) != 0;
  const bool second = (buttons & 2U) != 0;
  const bool stop = second && !state.second_down;
  state.second_down = second;
  if (first != state.raw) {
    state.raw = first;
    state.raw_since = time;
  }
  ButtonAction action = ButtonAction::kNone;
  if (state.raw != state.down && time - state.raw_since >= kButtonBounce) {
    action = Change(state, hold_to_feel);
  }
  if (state.down && state.raw && !state.spent && !hold_to_feel &&
      time - state.changed >= kButtonHeld) {
    state.spent = true;
    state.presses = 0;
    action = ButtonAction::kStop;
  }
  // `raw`: a press that has begun but may still be bounce keeps the wait open
  if (!state.down && !state.raw && state.presses == 1 && time - state.changed > kButtonDouble) {
    state.presses = 0;
    action = ButtonAction::kSay;
  }
  return stop ? ButtonAction::kStop : action;
}

}  // namespace moontrace
