#pragma once

#include <string>
#include <vector>

#include "sim/setup/options.h"

namespace moontrace {

/// `devices`: what is there and what it can do; `devices test NAME`: tries one step by step.
struct DevicesOptions {
  OutputOptions output;
  std::vector<std::string> words;
  bool udev = false;  ///< print the udev file that the profiles make, for developers
};
void AddOptions(CLI::App& app, DevicesOptions& options);
int Run(const DevicesOptions& options, Console& console);

}  // namespace moontrace
