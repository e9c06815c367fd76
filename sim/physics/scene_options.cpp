#include "sim/physics/scene_options.h"

#include <fmt/core.h>

#include <cmath>

#include "textures/base/error.h"

namespace moontrace {
namespace {

struct Range {
  const char* name;
  double value;
  double least;
  double greatest;
};

}  // namespace

void Check(const SceneOptions& options) {
  const Range ranges[] = {
      {"page stiffness", options.surface.stiffness, 1e-3, 1e7},
      {"force cap", options.surface.force_cap, 1e-6, 1e3},
      {"coupling stiffness", options.coupling_stiffness, 0, 1e7},
      {"coupling damping", options.coupling_damping, 0, 1e5},
      {"friction", options.friction, 0, 100},
      {"presliding stiffness", options.presliding_stiffness, 1e-3, 1e7},
      {"tick", options.tick, 1e-6, 0.1},
      {"tilt in radians", options.tilt, -1.6, 1.6},
  };
  if (options.unlabelled == Unlabelled::kContacts && options.rendering == Rendering::kDirect) {
    throw InputError("--unlabelled contacts needs the proxy; take it without --render direct");
  }
  for (const Range& range : ranges) {
    if (range.value >= range.least && range.value <= range.greatest) continue;
    throw InputError(fmt::format("{} {}: out of range; take {} to {}", range.name, range.value,
                                 range.least, range.greatest));
  }
}

}  // namespace moontrace
