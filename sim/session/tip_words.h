#pragma once

#include <optional>
#include <string>

#include "sim/loop/loop_types.h"
#include "sim/session/felt_page.h"
#include "sim/session/loop_session.h"

namespace moontrace {

/// Where the tip is and what it feels, in words. `pushes`: LiveDevice::pushes.
std::string Where(const FeltPage& page, bool pushes, const LoopSnapshot& now);

/// Turns to the page of a bookmark and says the way there from the tip, in words; none: how to set
/// one.
std::string WayToMark(LoopSession& session, const std::optional<LetterPlace>& mark,
                      const LoopSnapshot& now);

}  // namespace moontrace
