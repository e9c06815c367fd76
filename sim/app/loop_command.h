#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/app/options.h"

namespace moontrace {

/// `loop`: a text is felt in real time, with any device.
struct LoopCommandOptions {
  OutputOptions output;
  TextOptions text;
  StyleOptions style;
  LayoutOptions layout;
  FeelOptions feel;
  std::string device;
  std::optional<double> seconds;  ///< [s]
  std::optional<double> rate;     ///< [Hz]
  std::optional<double> scale;
  std::optional<double> press;  ///< [N]
  bool hold_to_feel = false;
  std::uint64_t seed = 1;
};
void AddOptions(CLI::App& app, LoopCommandOptions& options);
int Run(const LoopCommandOptions& options, Console& console);

}  // namespace moontrace
