#pragma once

#include <cstdint>
#include <optional>

#include "sim/session/device_choice.h"
#include "sim/session/view_feed.h"
#include "sim/session/view_options.h"
#include "sim/setup/options.h"

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
  ViewOptions view;
};
void AddOptions(CLI::App& app, LoopCommandOptions& options);
int Run(const LoopCommandOptions& options, Console& console);

/// All but the view's.
void AddLoopOptions(CLI::App& app, LoopCommandOptions& options);
/// With a view that is there already, or null. `aims`: see SessionRequest.
int RunLoop(const LoopCommandOptions& options, ViewFeed* view,
            const std::shared_ptr<Mailbox<StylusAim>>& aims, Console& console);

}  // namespace moontrace
