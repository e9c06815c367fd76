#pragma once

#include <string>
#include <string_view>

/// Sentences about the view in a window; see messages.h.
namespace moontrace::say {

/// The device "mouse" without a window.
std::string MouseNeedsWindow();
/// What the mouse does, and that it cannot push a hand.
std::string MouseIsSeen();

}  // namespace moontrace::say
