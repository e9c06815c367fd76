#pragma once

#include <cstdint>

namespace moontrace {

enum class ButtonAction : std::uint8_t { kNone, kSay, kBookmark, kStop };

/// What the buttons did so far; begins with all of them up.
struct ButtonState {
  bool down = false;         ///< the first button, freed of bounce
  bool raw = false;          ///< as last read
  double raw_since = 0;      ///< when `raw` last changed [s]
  double changed = 0;        ///< when `down` changed [s]
  int presses = 0;           ///< short presses that wait for what follows
  bool spent = false;        ///< this press has had its effect
  bool second_down = false;  ///< the second button, as last read
};

/// A change of the first button counts once it has stood this long [s]: contacts bounce for less.
inline constexpr double kButtonBounce = 0.01;
/// Held this long, the first button is a stop [s].
inline constexpr double kButtonHeld = 0.4;
/// A second press that begins within this time of a release makes a double press [s].
inline constexpr double kButtonDouble = 0.3;

/// Reads the buttons at `time` [s, ascending] and returns what they mean; each action once.
///
/// First button (bit 0): released within 0.4 s = say, returned 0.3 s after the release because a
/// second press may follow; two such presses = bookmark, on the second release; held 0.4 s = stop,
/// while it is still held. Second button (bit 1): stop, on the tick it goes down, bounce or not.
/// Further buttons mean nothing here.
///
/// `hold_to_feel`: the first button means "let me feel" for as long as it is held (the caller reads
/// that from the bit itself, so that letting go is never late): holding it is no stop then; short
/// and double presses keep their meaning.
ButtonAction AdvanceButtons(ButtonState& state, std::uint32_t buttons, double time,
                            bool hold_to_feel) noexcept;

}  // namespace moontrace
