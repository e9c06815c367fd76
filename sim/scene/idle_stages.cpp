#include "sim/scene/idle_stages.h"

#include <algorithm>

namespace moontrace {
namespace {

template <class Values>
bool AreZero(const Values* values, int count) noexcept {
  return std::all_of(values, values + count, [](Values value) { return value == 0; });
}

bool HasConstraints(const mjModel& m) noexcept {
  return (m.opt.disableflags & mjDSBL_CONTACT) == 0 || m.neq > 0 || m.ntendon > 0 ||
         !AreZero(m.jnt_limited, static_cast<int>(m.njnt)) ||
         !AreZero(m.dof_frictionloss, static_cast<int>(m.nv));
}

#if mjVERSION_HEADER < 230  // later ones have more passive forces than are looked for here
bool HasPassiveForces(const mjModel& m) noexcept {
  return m.ntendon > 0 || m.opt.density != 0 || m.opt.viscosity != 0 || mjcb_passive != nullptr ||
         !AreZero(m.jnt_stiffness, m.njnt) || !AreZero(m.dof_damping, m.nv);
}
#endif

}  // namespace

void SkipIdleStages(mjModel& m) noexcept {
  if (m.nsensor == 0) m.opt.disableflags |= mjDSBL_SENSOR;
  if (!HasConstraints(m)) m.opt.disableflags |= mjDSBL_CONSTRAINT;
#if mjVERSION_HEADER < 230
  if (!HasPassiveForces(m)) m.opt.disableflags |= mjDSBL_PASSIVE;
#endif
}

}  // namespace moontrace
