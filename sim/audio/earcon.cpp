#include "sim/audio/earcon.h"

#include "textures/base/enum_names.h"

namespace moontrace {

namespace {

constexpr std::string_view NameOf(Earcon earcon) {
  switch (earcon) {
    case Earcon::kStrokeStart:
      return "stroke_start";
    case Earcon::kStrokeEnd:
      return "stroke_end";
    case Earcon::kLetterDone:
      return "letter_done";
    case Earcon::kOffLine:
      return "off_line";
    case Earcon::kBackOn:
      return "back_on";
    case Earcon::kLineEnd:
      return "line_end";
    case Earcon::kPageEnd:
      return "page_end";
    case Earcon::kWrong:
      return "wrong";
    case Earcon::kRight:
      return "right";
    case Earcon::kHelpChanged:
      return "help_changed";
    case Earcon::kSafetyStop:
      return "safety_stop";
  }
  return {};
}
static_assert(CountNamed(&NameOf) == kEarcons);

}  // namespace

std::string_view KeyOf(Earcon earcon) { return NameOf(earcon); }

const std::array<Earcon, kEarcons>& AllEarcons() {
  static const std::array<Earcon, kEarcons> all = [] {
    std::array<Earcon, kEarcons> earcons{};
    for (std::size_t i = 0; i < kEarcons; ++i) earcons[i] = static_cast<Earcon>(i);
    return earcons;
  }();
  return all;
}

}  // namespace moontrace
