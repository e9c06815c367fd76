#pragma once

#include <glm/vec2.hpp>

namespace moontrace {

/// What happened in the window, as a plain value.
struct WindowEvent {
  enum class Kind { kMove, kLeave, kPress, kRelease, kWheel, kKey, kText };
  enum class Button { kNone, kLeft, kRight, kMiddle };
  enum class Key {
    kNone,
    kEnter,
    kEscape,
    kBackspace,
    kTab,
    kUp,
    kDown,
    kLeft,
    kRight,
    kPageUp,
    kPageDown,
    kHome
  };
  Kind kind = Kind::kMove;
  glm::dvec2 at{0, 0};            ///< of the mouse, from the lower left [points]
  Button button = Button::kNone;  ///< pressed or released
  double wheel = 0;               ///< notches, away from the hand above 0
  Key key = Key::kNone;           ///< pressed, again and again while held
  bool control = false, shift = false;
  char32_t text = 0;  ///< typed
};

}  // namespace moontrace
