#pragma once

#include <cstdint>
#include <optional>

#include "sim/app/device_choice.h"
#include "sim/app/options.h"

namespace moontrace {

/// `loop`: a text is felt in real time, with any device.
struct LoopCommandOptions {
  OutputOptions output;
  TextOptions text;
  StyleOptions style;
  LayoutOptions layout;
  FeelOptions feel;
  LiveOptions live;
  std::optional<double> press;  ///< [N]
  std::uint64_t seed = 1;
};
void AddOptions(CLI::App& app, LoopCommandOptions& options);
int Run(const LoopCommandOptions& options, Console& console);

}  // namespace moontrace
