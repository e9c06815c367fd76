#pragma once

#include <string>

#include "sim/session/view_options.h"
#include "sim/setup/options.h"

namespace moontrace {

/// `replay`: runs a record again; everything comes from the record.
struct ReplayOptions {
  OutputOptions output;
  std::string folder;
  bool check = false;
  ViewOptions view;
};
void AddOptions(CLI::App& app, ReplayOptions& options);
int Run(const ReplayOptions& options, Console& console);

}  // namespace moontrace
