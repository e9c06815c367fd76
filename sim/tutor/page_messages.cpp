#include "sim/tutor/page_messages.h"

#include <fmt/core.h>

#include "sim/console/wording.h"
#include "textures/base/text_file.h"
#include "textures/base/units.h"

namespace moontrace::say {

std::string PageWordsHelp() {
  return fmt::format(
      "Behind size, depth, width, spacing, pitch and tilt stands a number, as in size 20 mm, depth "
      "50 %, tilt 10 degrees; behind form {}; behind paper {}.",
      Joined(FormChoices(), " or "), Joined(PaperChoices(), " or "));
}

std::string PageBecomes(const PageCommand& command) {
  const double value = command.value;
  switch (command.word) {
    case PageWord::kSize:
      return fmt::format("letters of {} mm", Short(kMillimetres * value, 1));
    case PageWord::kDepth:
      return fmt::format("depth {} of the usual", Percent(value));
    case PageWord::kWidth:
      return fmt::format("width {} of the usual", Percent(value));
    case PageWord::kSpacing:
      return fmt::format("spaces {} of the usual", Percent(value));
    case PageWord::kPitch:
      return fmt::format("lines apart {} of the usual", Percent(value));
    case PageWord::kTilt:
      return fmt::format("page tilted by {} degrees", Short(InDegrees(value), 1));
    case PageWord::kEngraved:
      return "engraved, letters are grooves";
    case PageWord::kEmbossed:
      return "embossed, letters are ridges: press lightly";
    case PageWord::kForm:
      return fmt::format("H has the form {}", OneLine(command.h_form, 20));
    case PageWord::kPaper:
      return fmt::format("paper {}", command.paper ? NameOf(*command.paper) : "smooth");
  }
  return {};
}

std::string PageNow(const PageCommand& command) {
  std::string sentence = PageBecomes(command) + ".";
  if (sentence[0] >= 'a' && sentence[0] <= 'z') sentence[0] = static_cast<char>(sentence[0] - 32);
  return sentence;
}

std::string PageStays(std::string_view why) {
  return fmt::format("Stays as it was: {}.", OneLine(why, 300));
}

std::string PageStaysWhileScored() { return "The page stays while a trace is scored."; }

std::string NoTiltInPlane() {
  return "this device feels in the page's plane only; one with a third axis can tilt it";
}

std::string NoRoomForTurnMark(double least) {
  return fmt::format("--turn needs a margin of {:.0f} mm for its mark: --margin-mm {:.0f}",
                     kMillimetres * least, kMillimetres * least);
}
std::string MorePagesThan(std::size_t pages, std::size_t most) {
  return fmt::format("the text takes {}, and may have {}: choose smaller letters",
                     Counted(pages, "page", "pages"), most);
}

}  // namespace moontrace::say
