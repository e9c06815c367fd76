#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/session/device_choice.h"
#include "sim/session/view_options.h"
#include "sim/setup/guide_options.h"
#include "sim/setup/options.h"

namespace moontrace {

/// `trace`: the simulated stylus traces a text, page after page, and is scored; with `--device` a
/// person does, in real time.
struct TraceOptions {
  OutputOptions output;
  TextOptions text;
  StyleOptions style;
  LayoutOptions layout;
  FeelOptions feel;
  std::optional<double> press;  ///< [N]
  std::optional<double> speed;  ///< [m/s]
  GuideOptions guide;
  std::uint64_t seed = 1;
  bool seed_given = false;
  bool blank = false;
  std::string record;
  bool csv = false;
  std::string picture;

  ViewOptions view;
  LiveOptions live;  ///< device empty or "simulated": the rest counts for nothing and is refused
};
void AddOptions(CLI::App& app, TraceOptions& options);
int Run(const TraceOptions& options, Console& console);

}  // namespace moontrace
