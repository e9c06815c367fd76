#pragma once

#include <string>

#include "sim/app/loop_command.h"

namespace moontrace {

/// `view`: a loop in a window, or one picture of it.
struct ViewCommandOptions : LoopCommandOptions {
  std::string picture;  ///< empty: none
};
void AddOptions(CLI::App& app, ViewCommandOptions& options);
int Run(const ViewCommandOptions& given, Console& console);

}  // namespace moontrace
