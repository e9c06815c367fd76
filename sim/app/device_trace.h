#pragma once

#include "sim/app/trace_command.h"
#include "sim/wording/console.h"

namespace moontrace {

/// `trace --device NAME`: a person's own trace, or an emulated device's, in real time, scored as
/// the simulated one is, off the tick. Ends by "quit" or after `seconds`. Throws UsageError for
/// options that belong to the simulated stylus, DeviceError.
int TraceWithDevice(const TraceOptions& options, Console& console);

}  // namespace moontrace
