#pragma once

#include <array>
#include <optional>

#include "sim/setup/options.h"

namespace moontrace {

/// `probe`: what a tip meets at one point of the first page.
struct ProbeOptions {
  OutputOptions output;
  std::array<std::optional<double>, 3> point;  ///< from the first letter's lower left corner [m]
  TextOptions text;
  StyleOptions style;
  LayoutOptions layout;
  Surface surface;
};
void AddOptions(CLI::App& app, ProbeOptions& options);
int Run(const ProbeOptions& options, Console& console);

}  // namespace moontrace
