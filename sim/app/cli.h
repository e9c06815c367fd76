#pragma once

#include <string>
#include <vector>

#include "sim/console/console.h"

namespace moontrace {

/// The whole program but for the process: runs one command line (without the program's name) and
/// returns its exit code. Throws nothing; what went wrong is one line on the console's stderr.
int RunCli(const std::vector<std::string>& args, Console& console);

/// What may follow the program's name in a line that is to be typed: its commands,
/// and "COMMAND" for any of them.
std::vector<std::string> TypedAfterName();

}  // namespace moontrace
