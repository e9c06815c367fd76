#pragma once

#include "sim/learn/learn_options.h"

namespace moontrace {

void AddOptions(CLI::App& app, LearnOptions& options);
int Run(const LearnOptions& options, Console& console);

}  // namespace moontrace
