#pragma once

#include "sim/library/moontrace.h"
#include "textures/field/surface.h"

namespace moontrace {

/// A surface as a caller gives it; NULL and zeros are what is usual. Throws UsageError.
Surface SurfaceOf(const moontrace_surface* given);

}  // namespace moontrace
