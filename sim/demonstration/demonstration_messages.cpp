#include "sim/demonstration/demonstration_messages.h"

#include <fmt/core.h>

#include "sim/console/wording.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

std::string DemonstrationHelp() {
  return "Words: next, pause, go, again, more time, quit. Or the answer, while I ask.";
}
std::string DemonstrationPauses() { return "A pause. Say go when you like."; }
std::string DemonstrationGoesOn() { return "Going on."; }
std::string DemonstrationSlower() { return "More time from now on."; }
std::string DemonstrationUnknown(std::string_view given) {
  return fmt::format("Not a word here: {}. A question mark tells them.", OneLine(given, 16));
}

}  // namespace moontrace::say
