#pragma once

#include <functional>
#include <optional>

#include "sim/console/console.h"
#include "sim/console/line_reader.h"
#include "sim/session/loop_session.h"
#include "sim/session/view_feed.h"

namespace moontrace {

/// How a running session is led.
struct DriveOptions {
  std::optional<double> seconds;  ///< ends by itself; none: by "quit", or once input has ended
  bool sizes = true;              ///< words that change the page do something
  std::function<void(const LoopSample&)> sample;  ///< is given every tick, off the tick
  ViewFeed* view = nullptr;                       ///< shows it; closing its window ends it
};

/// Leads a running session from the text face until it ends: reads words, tells events, hands the
/// samples on. The loop has ended behind it, at zero force. False: nobody said a word, and there is
/// no terminal at which somebody could. Throws Interrupted.
bool Drive(LoopSession& session, const DriveOptions& options, Console& console);

/// Behind Drive: throws LackError if the device was lost and did not come back.
void RequireDevice(LoopSession& session);

/// What is said before a session: device, rate, priority, pages, scale.
void SayBeginning(const LoopSession& session, Console& console);

}  // namespace moontrace
