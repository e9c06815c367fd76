#include "sim/library/given_surface.h"

#include "sim/library/call.h"

namespace moontrace {

Surface SurfaceOf(const moontrace_surface* given) {
  Surface surface;
  if (given == nullptr) return surface;
  const moontrace_surface known = Given(given, sizeof(moontrace_surface), "surface");
  RequireNumber(known.stiffness, "surface.stiffness", 0);
  RequireNumber(known.force_cap, "surface.force_cap", 0);
  surface.law = RequireFlag(known.law, "surface.law") ? ForceLaw::kPaper : ForceLaw::kPotential;
  if (known.stiffness > 0) surface.stiffness = known.stiffness;
  if (known.force_cap > 0) surface.force_cap = known.force_cap;
  return surface;
}

}  // namespace moontrace
