#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace moontrace {

/// Short sounds that mean something; each also stands as text where it is played.
enum class Earcon : std::uint8_t {
  kStrokeStart,
  kStrokeEnd,
  kLetterDone,
  kOffLine,
  kBackOn,
  kLineEnd,  ///< end of a line of text, and the turn
  kPageEnd,
  kWrong,
  kRight,
  kHelpChanged,
  kSafetyStop,
};
inline constexpr std::size_t kEarcons = 11;

/// The key in data: "stroke_start", ...
std::string_view KeyOf(Earcon earcon);
/// All, in the order above.
const std::array<Earcon, kEarcons>& AllEarcons();

}  // namespace moontrace
