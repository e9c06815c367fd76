#pragma once

#include <string>

namespace moontrace {

/// Path of a file that comes with the program, e.g. "textures/scripts/moon.svg", "models/page.xml",
/// "devices/hand.toml": below $MOONTRACE_DATA if set, else beside the installed program or library
/// (share/moontrace in one of the two folders above its own), else in the source tree it was
/// built from. Throws LackError naming the file.
std::string ResourcePath(const std::string& relative);

}  // namespace moontrace
