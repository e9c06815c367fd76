#include "sim/app/view_messages.h"

#include <fmt/format.h>

namespace moontrace::say {

std::string MouseNeedsWindow() { return "--device mouse needs a window: add --view"; }

std::string MouseIsSeen() {
  return "The mouse moves the stylus; the wheel presses. Forces are seen, not felt.";
}

}  // namespace moontrace::say
