#include "sim/physics/model_loader.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "sim/physics/felt_object.h"
#include "sim/physics/mesh_label.h"
#include "sim/physics/mjcf.h"
#include "sim/physics/unlabelled.h"
#include "textures/base/error.h"
#include "textures/base/nearest_word.h"
#include "textures/base/resources.h"
#include "textures/base/text_file.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

constexpr std::size_t kGreatestFile = std::size_t{64} << 20;  ///< [bytes]

/// Compiles, with MuJoCo's own line numbers in the message if it fails: the prepared text has
/// others.
ModelPtr Compile(const std::string& prepared, const std::string& original,
                 const std::string& folder, const std::string& name,
                 std::vector<std::string>& remarks) {
  const std::string path = (std::filesystem::path(folder) / "moontrace-model.xml").string();
  std::string warning;
  ModelPtr m;
  try {
    m = CompileMjcf(prepared, path, name, warning);
  } catch (const InputError&) {
    CompileMjcf(original, path, name, warning);
    throw;
  }
  if (!warning.empty()) remarks.push_back("MuJoCo warns: " + warning);
  return m;
}

/// What a label may name: geoms, and bodies for their geoms without a name.
std::vector<std::string> Names(const mjModel& m) {
  std::vector<std::string> names;
  for (int i = 0; i < static_cast<int>(m.ngeom); ++i) {
    if (const char* geom = mj_id2name(&m, mjOBJ_GEOM, i)) names.emplace_back(geom);
  }
  for (int i = 0; i < static_cast<int>(m.nbody); ++i) {
    if (const char* body = mj_id2name(&m, mjOBJ_BODY, i)) names.emplace_back(body);
  }
  return names;
}

/// The number of a geom by its name; else of the only geom, or by BODY/N of the N-th from 1, of the
/// body of that name, since most geoms have none; below zero: there is none, or several.
int GeomNamed(const mjModel& m, const std::string& name) {
  const int geom = mj_name2id(&m, mjOBJ_GEOM, name.c_str());
  if (geom >= 0) return geom;
  int body = mj_name2id(&m, mjOBJ_BODY, name.c_str());
  if (body >= 0) return m.body_geomnum[body] == 1 ? m.body_geomadr[body] : -1;
  const std::size_t slash = name.rfind('/');
  if (slash == std::string::npos) return -1;
  const char* end = name.data() + name.size();
  int number = 0;
  const auto [stop, error] = std::from_chars(name.data() + slash + 1, end, number);
  body = mj_name2id(&m, mjOBJ_BODY, name.substr(0, slash).c_str());
  if (error != std::errc() || stop != end || body < 0) return -1;
  if (number < 1 || number > m.body_geomnum[body]) return -1;
  return m.body_geomadr[body] + number - 1;
}

std::string PlaceOf(const Label& label, const std::string& name) {
  return fmt::format("{}: label on '{}'", name, OneLine(label.geom));
}

std::string FacesOf(const Solid& solid) {
  std::string faces;
  for (const Face face : {Face::kTop, Face::kBottom, Face::kFront, Face::kBack, Face::kLeft,
                          Face::kRight, Face::kRound}) {
    if (!HasFace(solid, face)) continue;
    faces += (faces.empty() ? "" : ", ") + std::string(NameOf(face));
  }
  return faces;
}

/// A page's corner lies on its face, with room beyond it. What the text needs is known later.
void CheckAt(const Label& label, const Solid& solid, const std::string& place) {
  const Face face = label.face.value_or(UsualFace(solid));
  const Box room = RoomOn(solid, face);
  const glm::dvec2 at = label.middle.value_or(label.at);
  for (int axis = 0; axis < 2; ++axis) {
    if (axis == 0 && face == Face::kRound) continue;  // it may begin anywhere around
    if (at[axis] >= room.min[axis] && at[axis] < room.max[axis]) continue;
    if (!label.fitted.empty()) {  // the place is where the mesh was met
      throw InputError(fmt::format(
          "{}: there the mesh is flat from {:g} to {:g} mm along {} only, and the "
          "label's place lies at its edge: choose another face, or move it by middle_mm",
          place, 1e3 * room.min[axis], 1e3 * room.max[axis], axis == 0 ? 'x' : 'y'));
    }
    throw InputError(
        fmt::format("{}: {} lies outside the geom, from {:g} to {:g} mm along {}: move it in",
                    place, label.middle ? "middle_mm" : "at_mm", 1e3 * room.min[axis],
                    1e3 * room.max[axis], axis == 0 ? 'x' : 'y'));
  }
}

/// Sets what the label lies on. Throws InputError: there is no such geom.
void FindCarrier(const mjModel& m, const std::string& name, Label& label) {
  label.named = GeomNamed(m, label.geom);
  label.carrier =
      label.fitted.empty() ? label.named : mj_name2id(&m, mjOBJ_GEOM, label.fitted.c_str());
  if (label.carrier >= 0) return;
  const std::string place = PlaceOf(label, name);
  const int body = mj_name2id(&m, mjOBJ_BODY, label.geom.c_str());
  if (body >= 0) {
    const int count = m.body_geomnum[body];
    throw InputError(count == 0
                         ? place + ": that body has no geom; name another"
                         : fmt::format("{}: that body has {} geoms; write {}/1 to {}/{}", place,
                                       count, OneLine(label.geom), OneLine(label.geom), count));
  }
  const std::string nearest = NearestWord(label.geom, Names(m));
  throw InputError(place + ": no such geom; " +
                   (nearest.empty() ? "name a geom of the model, or its body"
                                    : "did you mean '" + OneLine(nearest) + "'?"));
}

std::vector<Label> ReadLabels(const mjModel& m, const std::string& name) {
  std::vector<Label> labels;
  for (int i = 0; i < static_cast<int>(m.ntext); ++i) {
    const char* text_name = mj_id2name(&m, mjOBJ_TEXT, i);
    if (text_name == nullptr || !IsLabelName(text_name)) continue;
    labels.push_back(ParseLabel(text_name, m.text_data + m.text_adr[i], name));
    const char* whole = text_name + kLabelPrefix.size();
    if (mj_name2id(&m, mjOBJ_GEOM, whole) >= 0) {  // a colon and a number of its own
      labels.back().geom = whole;
      labels.back().number = 0;
    }
    FindCarrier(m, name, labels.back());
  }
  if (labels.empty()) {
    throw InputError(name +
                     ": no label: add in <custom> a <text name=\"moontrace:GEOM\" data=\"{}\"/>");
  }
  return labels;
}

/// What the label lies on, checked: it has a chart and the face, and room at that place.
void CheckCarrier(const mjModel& m, const Label& label, const std::string& name) {
  const std::string place = PlaceOf(label, name);
  const std::optional<Solid> solid = SolidOf(m, label.carrier);
  if (!solid) {
    throw InputError(place +
                     ": that geom has no chart; put it on a plane, box, cylinder, sphere, capsule, "
                     "ellipsoid, mesh or height field");
  }
  if (label.face && !HasFace(*solid, *label.face)) {
    throw InputError(fmt::format("{}: that geom has no face {}; take {}", place,
                                 NameOf(*label.face), FacesOf(*solid)));
  }
  CheckAt(label, *solid, place);
}

/// Turns the geom about its own x axis through the page's origin, the far edge (+y) up. A body that
/// can move keeps its inertia where it was, so its geom must not turn.
void Tilt(mjModel& m, const Label& label, int geom, double tilt, const std::string& place) {
  if (tilt == 0) return;
  const int body = m.geom_bodyid[geom];
  if (m.body_weldid[body] != 0 || m.body_mocapid[m.body_rootid[body]] >= 0) {
    throw InputError(place + ": its body can move: tilt that in the model, not by --tilt-deg");
  }
  const Solid solid = SolidOf(m, geom).value_or(Solid());
  if (label.face.value_or(UsualFace(solid)) != Face::kTop) {
    throw InputError(place + ": only a top face is tilted by --tilt-deg: tilt it in the model");
  }
  mjtNum* pos = m.geom_pos + std::ptrdiff_t{3} * geom;
  mjtNum* quat = m.geom_quat + std::ptrdiff_t{4} * geom;
  const mjtNum turn[4] = {std::cos(tilt / 2), std::sin(tilt / 2), 0, 0};
  const glm::dvec3 origin = LabelChart(solid, PlaceOn(label, solid, {})).ToObject({0, 0, 0});
  const mjtNum origin_G[3] = {origin.x, origin.y, origin.z};
  mjtNum tilted_G[3], before_B[3], after_B[3], tilted_quat[4];
  mju_rotVecQuat(before_B, origin_G, quat);
  mju_rotVecQuat(tilted_G, origin_G, turn);
  mju_rotVecQuat(after_B, tilted_G, quat);
  for (int i = 0; i < 3; ++i) pos[i] += before_B[i] - after_B[i];
  mju_mulQuat(tilted_quat, quat, turn);
  mju_copy4(quat, tilted_quat);
  m.geom_sameframe[geom] = 0;  // no longer its body's own frame
}

/// True if joint `j` slides freely along the world's axis `axis`.
bool IsFreeSlide(const mjModel& m, int j, int axis) {
  const int dof = m.jnt_dofadr[j];
  for (int i = 0; i < 3; ++i) {
    if (std::abs(m.jnt_axis[3 * j + i] - (i == axis ? 1.0 : 0.0)) > 1e-9) return false;
  }
  return m.jnt_type[j] == mjJNT_SLIDE && m.jnt_limited[j] == 0 && m.jnt_stiffness[j] == 0 &&
         m.dof_damping[dof] == 0 && m.dof_frictionloss[dof] == 0;
}

/// Whether the body is `root` or hangs on it.
bool IsOf(const mjModel& m, int root, int body) {
  while (body > root) body = m.body_parentid[body];
  return body == root;
}

bool IsOfJoint(const mjModel& m, int root, int joint) {
  return joint >= 0 && IsOf(m, root, m.jnt_bodyid[joint]);
}
bool IsOfSite(const mjModel& m, int root, int site) {
  return site >= 0 && IsOf(m, root, m.site_bodyid[site]);
}

bool TendonTouches(const mjModel& m, int root, int tendon) {
  for (int i = 0; i < m.tendon_num[tendon]; ++i) {
    const int wrap = m.tendon_adr[tendon] + i, object = m.wrap_objid[wrap];
    if (m.wrap_type[wrap] == mjWRAP_JOINT && IsOfJoint(m, root, object)) return true;
    if (m.wrap_type[wrap] == mjWRAP_SITE && IsOfSite(m, root, object)) return true;
  }
  return false;
}

bool ActuatorTouches(const mjModel& m, int root, int actuator) {
  const int first = m.actuator_trnid[std::ptrdiff_t{2} * actuator];
  const int second = m.actuator_trnid[std::ptrdiff_t{2} * actuator + 1];
  switch (m.actuator_trntype[actuator]) {
    case mjTRN_JOINT:
    case mjTRN_JOINTINPARENT:
      return IsOfJoint(m, root, first);
    case mjTRN_TENDON:
      return TendonTouches(m, root, first);
    case mjTRN_SITE:
    case mjTRN_SLIDERCRANK:
      return IsOfSite(m, root, first) || IsOfSite(m, root, second);
    case mjTRN_BODY:
      return IsOf(m, root, first);
    default:
      return false;
  }
}

bool EqualityTouches(const mjModel& m, int root, int equality) {
  const int ends[] = {m.eq_obj1id[equality], m.eq_obj2id[equality]};
  for (const int end : ends) {
    if (end < 0) continue;
    switch (m.eq_type[equality]) {
      case mjEQ_CONNECT:
      case mjEQ_WELD:
        if (TiesSites(m, equality) ? IsOfSite(m, root, end) : IsOf(m, root, end)) return true;
        break;
      case mjEQ_JOINT:
        if (IsOfJoint(m, root, end)) return true;
        break;
      case mjEQ_TENDON:
        if (TendonTouches(m, root, end)) return true;
        break;
      default:
        break;
    }
  }
  return false;
}

/// What in the model could push the proxy besides coupling and page, and how to mend it; empty:
/// nothing. What cannot be known before, such as forces that a program applies, a tick notices.
std::string WhatHolds(const mjModel& m, int proxy) {
  for (int joint = 0; joint < static_cast<int>(m.njnt); ++joint) {
    if (m.jnt_bodyid[joint] == proxy || !IsOfJoint(m, proxy, joint)) continue;
    return "a jointed body hangs on it; take that body away";
  }
  for (int geom = 0; geom < static_cast<int>(m.ngeom); ++geom) {
    if (!IsOf(m, proxy, m.geom_bodyid[geom])) continue;
    if ((m.geom_contype[geom] | m.geom_conaffinity[geom]) != 0) {
      return "its geom would collide; set contype and conaffinity to 0";
    }
    for (int pair = 0; pair < static_cast<int>(m.npair); ++pair) {
      if (m.pair_geom1[pair] != geom && m.pair_geom2[pair] != geom) continue;
      return "a contact pair names its geom; take that <pair> away";
    }
  }
  for (int equality = 0; equality < static_cast<int>(m.neq); ++equality) {
    if (EqualityTouches(m, proxy, equality)) {
      return "an equality holds it; take that out of <equality>";
    }
  }
  for (int actuator = 0; actuator < static_cast<int>(m.nu); ++actuator) {
    if (ActuatorTouches(m, proxy, actuator)) {
      return "an actuator drives it; take that out of <actuator>";
    }
  }
  for (int tendon = 0; tendon < static_cast<int>(m.ntendon); ++tendon) {
    if (TendonTouches(m, proxy, tendon)) return "a tendon pulls it; take that out of <tendon>";
  }
  return "";
}

/// The force bound holds only for a proxy that nothing but coupling and page can hold back.
ProxyPlace FindProxy(const mjModel& m, const std::string& name) {
  const std::string place = name + ": moontrace_proxy: ";
  ProxyPlace proxy;
  proxy.body = mj_name2id(&m, mjOBJ_BODY, "moontrace_proxy");
  if (proxy.body < 0) throw InputError(place + "is not a body; take the name away");
  const int b = proxy.body;
  const int joint = m.body_jntadr[b];
  bool free =
      m.body_parentid[b] == 0 && m.body_jntnum[b] == 3 && m.body_quat[std::ptrdiff_t{4} * b] == 1;
  for (int i = 0; free && i < 3; ++i) free = IsFreeSlide(m, joint + i, i);
  if (!free) {
    throw InputError(place + "not free: give it, in the world, bare slide joints x, y, z");
  }
  const std::string holder = WhatHolds(m, b);
  if (!holder.empty()) throw InputError(place + holder);
  proxy.qpos = m.jnt_qposadr[joint];
  proxy.dof = m.jnt_dofadr[joint];
  proxy.mass = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    proxy.offset_W[i] = m.body_pos[3 * b + i] - m.qpos0[proxy.qpos + i];
    proxy.axis_mass[i] = m.dof_M0[proxy.dof + i];
    proxy.mass = std::min(proxy.mass, proxy.axis_mass[i]);
  }
  proxy.weight_mass = m.body_subtreemass[b];
  const int pad = mj_name2id(&m, mjOBJ_JOINT, "moontrace_pad");
  if (pad >= 0 && IsFreeSlide(m, pad, 0)) proxy.pad_dof = m.jnt_dofadr[pad];
  const int handle = mj_name2id(&m, mjOBJ_BODY, "moontrace_handle");
  if (handle >= 0) proxy.handle_mocap = m.body_mocapid[handle];
  return proxy;
}

/// MuJoCo's solvers end when a step gains less than their tolerance by a scale, the mean inertia of
/// all joints times their number, and they take sparse matrices for many joints. Without the
/// proxy's both are what the model has by itself, so that its contacts are solved to the same bit.
void HideFromSolvers(mjModel& m, const ProxyPlace& proxy) {
  const int hidden = proxy.pad_dof >= 0 ? 4 : 3;
  const auto all = static_cast<int>(m.nv), own = all - hidden;
  double sum = 0, theirs = 0;  // in MuJoCo's order
  for (int dof = 0; dof < all; ++dof) {
    const bool is_proxy = (dof >= proxy.dof && dof < proxy.dof + 3) || dof == proxy.pad_dof;
    sum += m.dof_M0[dof];
    if (!is_proxy) theirs += m.dof_M0[dof];
  }
  if (own > 0) {
    constexpr double kRounding = 1e-9;  // else the model gives a mean of its own
    const bool computed =
        std::abs(sum / all - m.stat.meaninertia) <= kRounding * m.stat.meaninertia;
    const double mean = computed ? theirs / own : m.stat.meaninertia;
    m.stat.meaninertia = mean * own / all;
  }
  constexpr int kSparse = 60;  // joints from which MuJoCo takes them
  if (m.opt.jacobian == mjJAC_AUTO) {
    m.opt.jacobian = own >= kSparse ? mjJAC_SPARSE : mjJAC_DENSE;
  }
}

/// What is known of a compiled model's labels and proxy; and turns off what hinders them. The
/// labels are read and lie on geoms.
void FindMoon(LoadedModel& loaded, const std::string& name, double tilt, std::size_t label,
              Unlabelled unlabelled) {
  mjModel& m = *loaded.m;
  if (label >= loaded.labels.size()) {
    throw InputError(fmt::format("{}: label {} of {}: count from 0; take one that is there", name,
                                 label, loaded.labels.size()));
  }
  if (unlabelled == Unlabelled::kPlain) {
    std::vector<Label> plain = PlainLabels(m, loaded.labels);
    std::move(plain.begin(), plain.end(), std::back_inserter(loaded.labels));
  }
  for (Label& each : loaded.labels) {
    CheckCarrier(m, each, name);
    const Solid solid = SolidOf(m, each.carrier).value_or(Solid());
    const bool round = each.face.value_or(UsualFace(solid)) == Face::kRound;
    if (round && !each.at_given && !each.middle) each.middle = {0, 0};
  }
  const Label& page = loaded.labels[label];
  const auto implied = std::count_if(loaded.labels.begin(), loaded.labels.end(),
                                     [](const Label& each) { return each.implied; });
  const std::size_t own = loaded.labels.size() - static_cast<std::size_t>(implied);
  if (own > 1) {
    loaded.remarks.push_back(
        fmt::format("{} labels in the model: the page is on '{}'", own, OneLine(NameOf(page))));
  }
  Tilt(m, page, page.carrier, tilt, PlaceOf(page, name));
  loaded.proxy = FindProxy(m, name);
  if (KeepAwake(m)) {
    loaded.remarks.push_back("sleeping is turned off: forces on a sleeping body are lost");
  }
  if (unlabelled == Unlabelled::kContacts) {
    LetProxyCollide(m, loaded.labels, loaded.proxy.body, name);
  }
  HideFromSolvers(m, loaded.proxy);
  SkipIdleStages(m);
}

}  // namespace

LoadedModel LoadModel(const std::string& xml, const std::string& folder, const std::string& name,
                      double tilt, std::size_t label, Unlabelled unlabelled) {
  LoadedModel loaded;
  const std::string proxy_xml = ReadTextFile(ResourcePath("models/proxy.xml"), kGreatestFile);
  const Mjcf mjcf = PrepareMjcf(xml, folder, name, proxy_xml);
  if (mjcf.proxy_inserted) {
    loaded.remarks.push_back("no moontrace_proxy in the model: models/proxy.xml was inserted");
  }
  loaded.xml = mjcf.xml;
  loaded.m = Compile(loaded.xml, xml, folder, name, loaded.remarks);
  loaded.labels = ReadLabels(*loaded.m, name);
  const std::vector<FittedGeom> fitted = FitLabels(*loaded.m, loaded.labels, name, loaded.remarks);
  if (!fitted.empty()) {
    loaded.xml = WithGeoms(loaded.xml, fitted, name);
    std::vector<std::string> again;  // the same warnings
    loaded.m = Compile(loaded.xml, loaded.xml, folder, name, again);
  }
  for (Label& each : loaded.labels) FindCarrier(*loaded.m, name, each);
  FindMoon(loaded, name, tilt, label, unlabelled);
  return loaded;
}

LoadedModel AdoptModel(ModelPtr m, std::string xml, const std::string& name, std::size_t label) {
  if (mj_name2id(m.get(), mjOBJ_BODY, "moontrace_proxy") < 0) {
    throw InputError(name + ": no body moontrace_proxy; include the models/proxy.xml of Moontrace");
  }
  LoadedModel loaded;
  loaded.m = std::move(m);
  loaded.xml = std::move(xml);
  loaded.labels = ReadLabels(*loaded.m, name);
  if (!FitLabels(*loaded.m, loaded.labels, name, loaded.remarks).empty()) {
    throw InputError(name +
                     ": a label on a mesh needs a geom fitted to it, which a compiled model lacks; "
                     "take the model.xml of a record, which has it");
  }
  for (Label& each : loaded.labels) FindCarrier(*loaded.m, name, each);
  FindMoon(loaded, name, 0, label, Unlabelled::kNothing);
  return loaded;
}

}  // namespace moontrace
