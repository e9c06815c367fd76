#include "sim/physics/mesh_label.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>
#include <pugixml.hpp>
#include <sstream>
#include <string_view>

#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

bool IsMesh(const mjModel& m, int geom) {
  return m.geom_type[geom] == mjGEOM_MESH || m.geom_type[geom] == mjGEOM_HFIELD;
}

bool IsField(const mjModel& m, int geom) { return m.geom_type[geom] == mjGEOM_HFIELD; }
const char* KindOf(const mjModel& m, int geom) {
  return IsField(m, geom) ? "height field" : "mesh";
}

double TrianglesOf(const mjModel& m, int geom) {
  const int id = m.geom_dataid[geom];
  if (!IsField(m, geom)) return m.mesh_facenum[id];
  return 2.0 * (m.hfield_nrow[id] - 1) * (m.hfield_ncol[id] - 1);
}

Pose PoseInBody(const mjModel& m, int geom) {
  const mjtNum* p = m.geom_pos + std::ptrdiff_t{3} * geom;
  mjtNum R[9];
  mju_quat2Mat(R, m.geom_quat + std::ptrdiff_t{4} * geom);
  return {glm::dmat3(R[0], R[3], R[6], R[1], R[4], R[7], R[2], R[5], R[8]),
          glm::dvec3(p[0], p[1], p[2])};
}

/// In the body's axes: a mesh's own are its principal ones, which nobody chose.
TriangleMesh MeshOf(const mjModel& m, int geom) {
  const int id = m.geom_dataid[geom];
  const Pose X_BG = PoseInBody(m, geom);
  TriangleMesh mesh;
  const float* points = m.mesh_vert + std::ptrdiff_t{3} * m.mesh_vertadr[id];
  for (std::ptrdiff_t i = 0; i < m.mesh_vertnum[id]; ++i) {
    const float* p = points + 3 * i;
    mesh.points.push_back(ToWorld(X_BG, glm::dvec3(p[0], p[1], p[2])));
  }
  const int* faces = m.mesh_face + std::ptrdiff_t{3} * m.mesh_faceadr[id];
  for (std::ptrdiff_t i = 0; i < m.mesh_facenum[id]; ++i) {
    const int* f = faces + 3 * i;
    mesh.faces.push_back({static_cast<std::size_t>(f[0]), static_cast<std::size_t>(f[1]),
                          static_cast<std::size_t>(f[2])});
  }
  return mesh;
}

/// The upper surface of a height field, in its own axes.
TriangleMesh HeightsOf(const mjModel& m, int geom) {
  const int id = m.geom_dataid[geom];
  const auto rows = static_cast<std::size_t>(m.hfield_nrow[id]);
  const auto columns = static_cast<std::size_t>(m.hfield_ncol[id]);
  const mjtNum* size = m.hfield_size + std::ptrdiff_t{4} * id;
  const float* heights = m.hfield_data + m.hfield_adr[id];
  TriangleMesh mesh;
  mesh.points.reserve(rows * columns);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const double x = 2.0 * static_cast<double>(column) / static_cast<double>(columns - 1) - 1;
      const double y = 2.0 * static_cast<double>(row) / static_cast<double>(rows - 1) - 1;
      mesh.points.emplace_back(size[0] * x, size[1] * y,
                               size[2] * double{heights[row * columns + column]});
    }
  }
  for (std::size_t row = 0; row + 1 < rows; ++row) {
    for (std::size_t column = 0; column + 1 < columns; ++column) {
      const std::size_t a = row * columns + column, b = a + columns;
      mesh.faces.push_back({a, a + 1, b + 1});
      mesh.faces.push_back({a, b + 1, b});
    }
  }
  return mesh;
}

/// A face of the box around a mesh, as faces of a box are seen: outwards, to the right, up.
struct Side {
  glm::dvec3 out{0, 0, 1}, right{1, 0, 0}, up{0, 1, 0};
};
Side SideOf(Face face) {
  switch (face) {
    case Face::kTop:
    case Face::kRound:
      break;
    case Face::kBottom:
      return {{0, 0, -1}, {1, 0, 0}, {0, -1, 0}};
    case Face::kFront:
      return {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
    case Face::kBack:
      return {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
    case Face::kLeft:
      return {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
    case Face::kRight:
      return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  }
  return {};
}

/// What a label's face and middle meet of a mesh. Frame F: the mesh's.
Fit FitAt(const TriangleMesh& mesh, const Side& side, glm::dvec2 middle) {
  glm::dvec3 low(1e300), high(-1e300);
  for (const glm::dvec3& p : mesh.points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const glm::dvec3 box = 0.5 * (low + high);
  const double outside = glm::length(high - low);
  const glm::dvec3 from = box + middle.x * side.right + middle.y * side.up + outside * side.out;
  return FitSolid(mesh, from, -side.out, side.right);
}

/// A label on a mesh, with what was fitted there.
struct Fitted {
  std::size_t label = 0;  ///< its number
  int geom = -1;
  FittedSolid solid;
  Pose X_BO;  ///< of the solid in its body
};

bool IsAlike(const Fitted& a, const Fitted& b) {
  constexpr double kAlike = 1e-6;  // [m], and of axes
  double apart = glm::length(a.solid.solid.half - b.solid.solid.half);
  apart += glm::length(a.X_BO.p - b.X_BO.p);
  for (int i = 0; i < 3; ++i) apart += glm::length(a.X_BO.R[i] - b.X_BO.R[i]);
  return a.solid.solid.kind == b.solid.solid.kind && apart < kAlike;
}

/// If the flat part lies on a flat face of what carries another label, as the back of a plate or
/// the cap of a cylinder does, its label goes there: of two solids in one place each would push the
/// tip out of the other's grooves. Returns that face.
std::optional<Face> FaceShared(const Fitted& carrier, Fitted& flat) {
  constexpr double kSame = 1e-5;  // [m], and of axes
  const Solid& solid = carrier.solid.solid;
  if (flat.solid.solid.kind != SolidKind::kBox || solid.kind == SolidKind::kSphere) return {};
  const glm::dvec3& half = flat.solid.solid.half;
  const auto in_carrier = [&](glm::dvec3 p_O) {
    return FromWorld(carrier.X_BO, ToWorld(flat.X_BO, p_O));
  };
  const glm::dvec3 at = in_carrier({flat.solid.on_face, half.z});
  for (const Face face :
       {Face::kTop, Face::kBottom, Face::kFront, Face::kBack, Face::kLeft, Face::kRight}) {
    if (!HasFace(solid, face)) continue;
    const Side side = SideOf(face);
    const glm::dvec3 out = TurnFromWorld(carrier.X_BO, flat.X_BO.R[2]);
    if (glm::length(out - side.out) > kSame) continue;
    const double height = solid.kind == SolidKind::kCylinder
                              ? solid.half.y
                              : glm::dot(solid.half, glm::abs(side.out));
    if (std::abs(glm::dot(at, side.out) - height) > kSame) continue;
    bool within = true;
    for (const double x : {-half.x, half.x}) {
      for (const double y : {-half.y, half.y}) {
        within = within && NearestOf(solid, in_carrier({x, y, half.z})).height < kSame;
      }
    }
    if (!within) continue;
    const glm::dvec3 right = TurnFromWorld(carrier.X_BO, flat.X_BO.R[0]);
    flat.solid.turn += std::atan2(glm::dot(right, side.up), glm::dot(right, side.right));
    flat.solid.on_face = {glm::dot(at, side.right), glm::dot(at, side.up)};
    return face;
  }
  return {};
}

/// Round parts first, then flat ones from the largest on: others may lie on their faces.
double Rank(const Fitted& fitted) {
  const Solid& solid = fitted.solid.solid;
  return solid.kind == SolidKind::kBox ? solid.half.x * solid.half.y * solid.half.z : 1e9;
}

std::string WordsOf(const FittedSolid& fitted) {
  const glm::dvec3 half = 1e3 * fitted.solid.half;
  std::string words;
  if (fitted.solid.kind == SolidKind::kBox) {
    words = fmt::format("its flat part of {:.3g} x {:.3g} mm", 2 * half.x, 2 * half.y);
  } else if (fitted.solid.kind == SolidKind::kCylinder) {
    words =
        fmt::format("its cylinder of {:.3g} mm radius and {:.3g} mm length", half.x, 2 * half.y);
  } else {
    words = fmt::format("its sphere of {:.3g} mm radius", half.x);
  }
  return words + fmt::format(", true to {:.2g} mm", std::max(0.001, 1e3 * fitted.error));
}

/// A hostile mesh takes neither memory nor time: some 0.3 kB and 2 us a triangle.
void RequireFew(double triangles, double of_all_labels, const std::string& place) {
  constexpr double kMost = 500000, kMostOfAll = 4e6;
  if (triangles <= kMost && of_all_labels <= kMostOfAll) return;
  throw InputError(
      fmt::format("{}: {:.0f} triangles, {:.0f} with those of labels before it; at most "
                  "{:.0f} and {:.0f}: make it coarser",
                  place, triangles, of_all_labels, kMost, kMostOfAll));
}

/// What the label asks for, fitted. Throws InputError.
FittedSolid FitLabel(const mjModel& m, int geom, const Label& label, const std::string& name) {
  const std::string place = fmt::format("{}: label on '{}'", name, OneLine(label.geom));
  const bool field = IsField(m, geom);
  const char* what = KindOf(m, geom);
  if (label.at_given) {
    throw InputError(fmt::format("{}: a {} has no corner; give middle_mm", place, what));
  }
  const Face face = label.face.value_or(Face::kTop);
  if (face == Face::kRound || (field && face != Face::kTop)) {
    throw InputError(fmt::format("{}: a {} has no face {}; take {}", place, what, NameOf(face),
                                 field ? "top" : "top, bottom, front, back, left, right"));
  }
  const glm::dvec2 middle = label.middle.value_or(glm::dvec2(0, 0));
  const Fit fit = FitAt(field ? HeightsOf(m, geom) : MeshOf(m, geom), SideOf(face), middle);
  if (fit.solid) return *fit.solid;
  throw InputError(
      fmt::format("{}: seen from {} the {} has no flat, cylindrical or spherical part "
                  "at its middle_mm: {}; choose another face or place",
                  place, NameOf(face), what, fit.why));
}

/// Thinner, so that solids of several parts of a mesh do not lie within each other; at most half as
/// deep as the mesh is there.
void MakeSheet(Fitted& fitted) {
  constexpr double kSheet = 6e-3;  // [m]: deeper than any press that is held
  if (fitted.solid.solid.kind != SolidKind::kBox) return;
  double& half = fitted.solid.solid.half.z;
  const double depth = std::min(half, kSheet);
  fitted.X_BO.p += (half - 0.5 * depth) * fitted.X_BO.R[2];
  half = 0.5 * depth;
}

std::string BodyNameOf(const mjModel& m, int geom) {
  const char* body = mj_id2name(&m, mjOBJ_BODY, m.geom_bodyid[geom]);
  return body == nullptr ? "" : body;
}

pugi::xml_node BodyOf(pugi::xml_node node) {
  while (node) {
    const std::string_view tag = node.name();
    if (tag == "body" || tag == "worldbody") return node;
    node = node.parent();
  }
  return {};
}

std::string_view NameOfBody(const pugi::xml_node& body) {
  return std::string_view(body.name()) == "worldbody"
             ? std::string_view("world")
             : std::string_view(body.attribute("name").value());
}

/// Every number as it is.
std::string Exactly(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values)
    text += fmt::format("{}{:.17g}", text.empty() ? "" : " ", value);
  return text;
}

void Append(pugi::xml_node body, const FittedGeom& fitted) {
  const glm::dmat3& R = fitted.X_BO.R;
  const mjtNum rows[9] = {R[0][0], R[1][0], R[2][0], R[0][1], R[1][1],
                          R[2][1], R[0][2], R[1][2], R[2][2]};
  mjtNum quat[4];
  mju_mat2Quat(quat, rows);
  pugi::xml_node geom = body.append_child("geom");
  const auto set = [&geom](const char* key, const std::string& value) {
    geom.append_attribute(key).set_value(value.c_str());
  };
  const glm::dvec3& p = fitted.X_BO.p;
  const glm::dvec3& half = fitted.solid.half;
  set("name", fitted.name);
  set("class", "moontrace_fitted");
  set("type", fitted.solid.kind == SolidKind::kBox        ? "box"
              : fitted.solid.kind == SolidKind::kCylinder ? "cylinder"
                                                          : "sphere");
  set("size", Exactly({half.x, half.y, half.z}));
  set("pos", Exactly({p.x, p.y, p.z}));
  set("quat", Exactly({quat[0], quat[1], quat[2], quat[3]}));
  set("mass", "0");
  set("contype", "0");
  set("conaffinity", "0");
  set("group", "5");
  set("rgba", "0 0 0 0");
}

}  // namespace

std::vector<FittedGeom> FitLabels(const mjModel& m, std::vector<Label>& labels,
                                  const std::string& name, std::vector<std::string>& remarks) {
  std::vector<Fitted> fits;
  double triangles = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const int geom = labels[i].carrier;
    if (!IsMesh(m, geom)) continue;
    triangles += TrianglesOf(m, geom);
    RequireFew(TrianglesOf(m, geom), triangles,
               fmt::format("{}: label on '{}'", name, OneLine(labels[i].geom)));
    const FittedSolid solid = FitLabel(m, geom, labels[i], name);
    const Pose X_BF = IsField(m, geom) ? PoseInBody(m, geom) : Pose();
    fits.push_back({i, geom, solid, {X_BF.R * solid.X_FO.R, ToWorld(X_BF, solid.X_FO.p)}});
    remarks.push_back(fmt::format("label on {} '{}': lies on {}", KindOf(m, geom),
                                  OneLine(NameOf(labels[i])), WordsOf(solid)));
  }
  std::stable_sort(fits.begin(), fits.end(),
                   [](const Fitted& a, const Fitted& b) { return Rank(a) > Rank(b); });
  std::vector<Fitted> carriers;
  std::vector<FittedGeom> geoms;
  for (Fitted& fitted : fits) {
    Label& label = labels[fitted.label];
    std::size_t carrier = 0, others = 0;  // which, and how many of that mesh
    std::optional<Face> face;
    for (; carrier < carriers.size() && !face; ++carrier) {
      const Fitted& other = carriers[carrier];
      if (other.geom != fitted.geom) continue;
      ++others;
      face = IsAlike(other, fitted) ? UsualFace(fitted.solid.solid) : FaceShared(other, fitted);
    }
    if (face) {
      --carrier;
    } else {
      face = UsualFace(fitted.solid.solid);
      if (others > 0) MakeSheet(fitted);
      carriers.push_back(fitted);
      geoms.push_back({fmt::format("moontrace_fitted:{}:{}", label.geom, others), label.geom,
                       BodyNameOf(m, fitted.geom), fitted.solid.solid, fitted.X_BO});
    }
    label.fitted = geoms[carrier].name;
    label.error = fitted.solid.error;
    label.face = face;
    label.middle = fitted.solid.on_face;
    label.turn += fitted.solid.turn;
  }
  // a record's model has them already
  const auto is_there = [&m](const FittedGeom& geom) {
    return mj_name2id(&m, mjOBJ_GEOM, geom.name.c_str()) >= 0;
  };
  geoms.erase(std::remove_if(geoms.begin(), geoms.end(), is_there), geoms.end());
  return geoms;
}

std::string WithGeoms(const std::string& xml, const std::vector<FittedGeom>& geoms,
                      const std::string& name) {
  pugi::xml_document document;
  document.load_buffer(xml.data(), xml.size(),
                       pugi::parse_default | pugi::parse_ws_pcdata | pugi::parse_comments);
  pugi::xml_node root = document.document_element();
  for (const pugi::xml_node& compiler : root.children("compiler")) {
    if (std::string_view(compiler.attribute("coordinate").value()) == "global") {
      throw InputError(name +
                       ": a label on a mesh needs local coordinates: take "
                       "coordinate=\"global\" out of <compiler>");
    }
  }
  for (const FittedGeom& fitted : geoms) {
    pugi::xml_node body = BodyOf(root.find_node([&fitted](const pugi::xml_node& node) {
      const std::string_view tag = node.name(), called = node.attribute("name").value();
      if (tag == "worldbody") return fitted.body == "world";
      return (tag == "geom" && called == fitted.on) ||
             (tag == "body" && !fitted.body.empty() && called == fitted.body);
    }));
    if (!body || NameOfBody(body) != fitted.body) {
      throw InputError(
          fmt::format("{}: label on '{}': a label on a mesh needs a geom that is "
                      "written in a body of the model itself: write it there",
                      name, OneLine(fitted.on)));
    }
    Append(body, fitted);
  }
  if (!geoms.empty()) {
    pugi::xml_node defaults = root.child("default");
    if (!defaults) defaults = root.prepend_child("default");
    defaults.append_child("default").append_attribute("class").set_value("moontrace_fitted");
  }
  std::ostringstream text;
  document.save(text, "", pugi::format_raw | pugi::format_no_declaration);
  return text.str();
}

}  // namespace moontrace
