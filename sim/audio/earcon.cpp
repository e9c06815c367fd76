#include "sim/audio/earcon.h"

namespace moontrace {

namespace {

constexpr std::array<std::string_view, kEarcons> kKeys = {
    "stroke_start", "stroke_end", "letter_done", "off_line",     "back_on",    "line_end",
    "page_end",     "wrong",      "right",       "help_changed", "safety_stop"};

}  // namespace

std::string_view KeyOf(Earcon earcon) { return kKeys[static_cast<std::size_t>(earcon)]; }

const std::array<Earcon, kEarcons>& AllEarcons() {
  static const std::array<Earcon, kEarcons> all = [] {
    std::array<Earcon, kEarcons> earcons{};
    for (std::size_t i = 0; i < kEarcons; ++i) earcons[i] = static_cast<Earcon>(i);
    return earcons;
  }();
  return all;
}

}  // namespace moontrace
