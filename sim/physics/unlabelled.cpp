#include "sim/physics/unlabelled.h"

#include <algorithm>
#include <cstddef>

#include "sim/physics/label_place.h"
#include "sim/physics/mujoco_compat.h"
#include "textures/base/error.h"

namespace moontrace {

namespace {

bool Collides(const mjModel& m, int geom) {
  return (m.geom_contype[geom] | m.geom_conaffinity[geom]) != 0;
}

/// Whether geoms of the body collide.
bool BodyCollides(const mjModel& m, int body) {
  for (int i = 0; i < m.body_geomnum[body]; ++i) {
    if (Collides(m, m.body_geomadr[body] + i)) return true;
  }
  return false;
}

bool IsSeen(const mjModel& m, int geom) {
  constexpr int kShown = 2;  // groups that MuJoCo's viewer shows at first
  return m.geom_group[geom] <= kShown;
}

/// Moontrace's own, or with a label.
bool IsTaken(const mjModel& m, const std::vector<Label>& labels, int geom) {
  for (const char* own : {"moontrace_proxy", "moontrace_handle"}) {
    if (m.geom_bodyid[geom] == mj_name2id(&m, mjOBJ_BODY, own)) return true;
  }
  return std::any_of(labels.begin(), labels.end(), [geom](const Label& label) {
    return label.carrier == geom || label.named == geom;
  });
}

std::string NameOfGeom(const mjModel& m, int geom) {
  if (const char* name = mj_id2name(&m, mjOBJ_GEOM, geom)) return name;
  const int body = m.geom_bodyid[geom];
  const char* of = mj_id2name(&m, mjOBJ_BODY, body);
  if (of == nullptr) return {};
  return std::string(of) + "/" + std::to_string(geom - m.body_geomadr[body] + 1);
}

/// So small a sphere must not be pressed in by more than its radius, where MuJoCo knows its depth
/// no more: its contacts are as hard as they can be at 1 kHz, whatever the other geom asks for.
void Harden(mjModel& m, int geom) {
  constexpr double kAlone = 1e6;  // of a mixture of both geoms' values
  m.geom_solmix[geom] = kAlone;
  mjtNum* solref = m.geom_solref + std::ptrdiff_t{mjNREF} * geom;
  solref[0] = 0.002;  // time constant, two steps, the least that MuJoCo takes [s]
  solref[1] = 1;      // critically damped
  mjtNum* solimp = m.geom_solimp + std::ptrdiff_t{mjNIMP} * geom;
  solimp[0] = 0.95;
  solimp[1] = 0.99;
  solimp[2] = 1e-4;  // depth at which the latter is reached [m]
}

}  // namespace

std::vector<Label> PlainLabels(const mjModel& m, const std::vector<Label>& labels) {
  std::vector<Label> plain;
  for (int geom = 0; geom < static_cast<int>(m.ngeom); ++geom) {
    const bool there =
        Collides(m, geom) || (IsSeen(m, geom) && !BodyCollides(m, m.geom_bodyid[geom]));
    if (!there || IsTaken(m, labels, geom) || !SolidOf(m, geom)) continue;
    Label label;
    label.geom = NameOfGeom(m, geom);
    label.carrier = label.named = geom;
    label.implied = true;
    plain.push_back(std::move(label));
  }
  return plain;
}

void LetProxyCollide(mjModel& m, const std::vector<Label>& labels, int proxy_body,
                     const std::string& name) {
  unsigned used = 0;
  for (int geom = 0; geom < static_cast<int>(m.ngeom); ++geom) {
    used |= static_cast<unsigned>(m.geom_contype[geom] | m.geom_conaffinity[geom]);
  }
  int bit = 0;
  for (int i = 0; i < 31 && bit == 0; ++i) {
    if ((used >> i & 1U) == 0) bit = 1 << i;
  }
  if (bit == 0) {
    throw InputError(
        name +
        ": every bit of contype and conaffinity is used, none is left for the tip; free "
        "one, or take --unlabelled plain");
  }
  for (int geom = 0; geom < static_cast<int>(m.ngeom); ++geom) {
    if (m.geom_bodyid[geom] == proxy_body) {
      SetCollision(m, geom, bit, 0);
      Harden(m, geom);
    } else if (Collides(m, geom) && !IsTaken(m, labels, geom)) {
      SetCollision(m, geom, m.geom_contype[geom], m.geom_conaffinity[geom] | bit);
    }
  }
}

}  // namespace moontrace
