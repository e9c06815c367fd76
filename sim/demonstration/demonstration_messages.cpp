#include "sim/demonstration/demonstration_messages.h"

namespace moontrace::say {

std::string DemonstrationHelp() {
  return "Words: stop, next, again, go, pause, quit, more time. Or the answer, while I ask.";
}
std::string DemonstrationPauses() { return "A pause. Say go when you like."; }
std::string DemonstrationGoesOn() { return "Going on."; }
std::string DemonstrationSlower() { return "More time from now on."; }

}  // namespace moontrace::say
