#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sim/view/view_words.h"

/// Sentences of the view, and the words drawn in it.
namespace moontrace::say {

/// What the view does from now on.
std::string ViewObeys(ViewWord word);
std::string ViewWholeModel();
/// Of a model: what it looks at, what it could look at, why it does not.
std::string ViewLooksAt(std::string_view name);
std::string ViewNames(const std::vector<std::string>& names);
std::string ViewRefuses(std::string_view why);
/// The display went away while the view was open.
std::string ViewLost();
/// The view had to stop drawing, `why` being one line.
std::string ViewStopped(const std::string& why);

/// Room for neither panel nor lines.
std::string ViewTooSmall();
std::string ViewMinimised();

/// How hard the mouse's left button presses [N].
std::string ViewPress(double press);

namespace plot {
inline constexpr const char* kForce = "Force [N]";
inline constexpr const char* kError = "Error [mm]";
inline constexpr const char* kLateness = "Tick lateness [us]";
inline constexpr const char* kHeat = "Motor heat [%]";
inline constexpr const char* kTime = "time [s]";
}  // namespace plot

}  // namespace moontrace::say
