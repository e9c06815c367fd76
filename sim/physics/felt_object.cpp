#include "sim/physics/felt_object.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

/// How readily a geom's body gives way [1/kg]: the greatest velocity that a unit impulse on a
/// corner of the geom gives that corner, from J M^-1 J^T; at least its greatest eigenvalue, by its
/// row sums. Zero for what rests. Constraints, which hold it back, do not count.
double ComplianceOf(const mjModel& m, mjData& d, const FeltObject& object) {
  if (!object.pushed) return 0;
  const auto nv = static_cast<std::size_t>(m.nv);
  std::vector<mjtNum> J(3 * nv), solved(3 * nv);
  glm::dvec3 half = object.solid.half;
  switch (object.solid.kind) {
    case SolidKind::kPlane:
    case SolidKind::kBox:
    case SolidKind::kEllipsoid:
      break;
    case SolidKind::kSphere:
      half = glm::dvec3(half.x);
      break;
    case SolidKind::kCylinder:
      half = {half.x, half.x, half.y};
      break;
    case SolidKind::kCapsule:
      half = {half.x, half.x, half.x + half.y};
      break;
  }
  const Pose X_WG = PoseOfGeom(d, object.geom);
  double greatest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                          (corner & 4) != 0 ? 1 : -1);
    const glm::dvec3 p_W = ToWorld(X_WG, sign * half);
    const mjtNum corner_W[3] = {p_W.x, p_W.y, p_W.z};
    mj_jac(&m, &d, J.data(), nullptr, corner_W, object.body);
    mj_solveM(&m, &d, solved.data(), J.data(), 3);
    for (std::size_t row = 0; row < 3; ++row) {
      double sum = 0;
      for (std::size_t column = 0; column < 3; ++column) {
        sum += std::abs(
            std::inner_product(J.begin() + static_cast<std::ptrdiff_t>(row * nv),
                               J.begin() + static_cast<std::ptrdiff_t>((row + 1) * nv),
                               solved.begin() + static_cast<std::ptrdiff_t>(column * nv), 0.0));
      }
      greatest = std::max(greatest, sum);
    }
  }
  return greatest;
}

/// A geom answers in one way: what one of its labels asks for holds for all.
void Join(const Label& label, const std::optional<double>& asked, const char* what,
          const std::string& name, std::optional<double>& joined) {
  if (!asked) return;
  if (joined && *joined != *asked) {
    throw InputError(name + ": labels on '" + OneLine(label.geom) + "' ask for two values of " +
                     what + "; give one of them");
  }
  joined = asked;
}

}  // namespace

bool FeltObject::IsPage() const noexcept {
  return solid.kind == SolidKind::kPlane && labels.size() == 1 &&
         labels.front().chart.place().turn == 0;
}

void FeltObject::Settle() noexcept {
  law = LawOn(solid, surface, labels);
  through_depth = ThroughDepthOn(solid, surface, labels);
  // from where the surface's whole force has grown
  thin = law.support + law.normal / surface.stiffness;
  if (solid.kind == SolidKind::kBox) {
    for (int axis = 0; axis < 3; ++axis) {
      if (solid.half[axis] >= thin) through_depth = std::min(through_depth, solid.half[axis]);
    }
  }
  if (solid.kind == SolidKind::kCylinder && solid.half.y >= thin) {
    through_depth = std::min(through_depth, solid.half.y);
  }
  double rise = 0;
  for (const LabelOnSolid& label : labels) {
    if (label.field != nullptr) rise = std::max(rise, label.field->greatest_rise());
  }
  reach = Radius(solid) + rise;
  constexpr double kTravel = 0.002;  // [m]: 2 m/s within a tick of 1 ms
  near = rise + kTravel;
}

std::vector<FeltObject> FeltObjects(const mjModel& m, mjData& d, const std::vector<Label>& labels,
                                    const SceneOptions& options, const std::string& name) {
  std::vector<FeltObject> objects;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const int geom = labels[i].carrier;
    auto object = std::find_if(objects.begin(), objects.end(),
                               [&](const FeltObject& other) { return other.geom == geom; });
    if (object == objects.end()) {
      FeltObject made;
      made.geom = geom;
      made.body = m.geom_bodyid[geom];
      made.pushed = m.body_weldid[made.body] != 0;
      made.moves = made.pushed || m.body_mocapid[m.body_rootid[made.body]] >= 0;
      const int root = m.body_rootid[made.body];
      made.free = m.body_jntnum[root] > 0 && m.jnt_type[m.body_jntadr[root]] == mjJNT_FREE;
      made.solid = SolidOf(m, geom).value_or(Solid());
      made.floating = FloatingBody(m, made.body);
      made.compliance = ComplianceOf(m, d, made);
      objects.push_back(std::move(made));
      object = objects.end() - 1;
    }
    object->numbers.push_back(i);
  }
  for (FeltObject& object : objects) {
    std::optional<double> stiffness, cap;
    for (const std::size_t number : object.numbers) {
      const Label& label = labels[number];
      Join(label, label.stiffness, "stiffness_n_per_m", name, stiffness);
      Join(label, label.force_cap, "force_cap_n", name, cap);
      const Box text_P = number == options.label ? options.text_P : Box();
      object.labels.push_back(Lay(label, object.solid, nullptr, text_P));
    }
    object.surface = options.surface;
    object.surface.stiffness = stiffness.value_or(options.surface.stiffness);
    // never above what a device holds
    object.surface.force_cap =
        std::min(options.surface.force_cap, cap.value_or(options.surface.force_cap));
    object.Settle();
  }
  return objects;
}

}  // namespace moontrace
