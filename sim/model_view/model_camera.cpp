#include "sim/model_view/model_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "sim/model_view/visibility.h"
#include "sim/physics/felt_object.h"

namespace moontrace {

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kNearest = 0.004, kFarthest = 1e4;  // distances [m]
constexpr double kFilled = 0.88;                     // of the picture, by what is looked at
constexpr double kMostOfGeom = 6;                    // half lengths of a text

glm::dvec3 PlaceOf(const mjData& d, int geom) { return PoseOfGeom(d, geom).p; }

/// MuJoCo gives planes none.
double RadiusOf(const mjModel& m, int geom) {
  if (m.geom_type[geom] != mjGEOM_PLANE) return m.geom_rbound[geom];
  const mjtNum* half = m.geom_size + std::ptrdiff_t{3} * geom;
  return half[0] > 0 && half[1] > 0 ? std::hypot(half[0], half[1]) : 0;
}

/// Points between which a geom lies; of a plane without end none.
void AddCorners(const mjModel& m, const mjData& d, int geom, std::vector<glm::dvec3>& points_W) {
  const mjtNum* size = m.geom_size + std::ptrdiff_t{3} * geom;
  glm::dvec3 half(m.geom_rbound[geom]);
  switch (m.geom_type[geom]) {
    case mjGEOM_PLANE:
      half = {size[0], size[1], 0};
      if (RadiusOf(m, geom) <= 0) return;
      break;
    case mjGEOM_SPHERE:
      half = glm::dvec3(0.8 * size[0]);  // its cube's corners stand out
      break;
    case mjGEOM_CYLINDER:
      half = {size[0], size[0], size[1]};
      break;
    case mjGEOM_CAPSULE:
      half = {size[0], size[0], size[0] + size[1]};
      break;
    case mjGEOM_BOX:
    case mjGEOM_ELLIPSOID:
      half = {size[0], size[1], size[2]};
      break;
    default:
      break;
  }
  const Pose X_WG = PoseOfGeom(d, geom);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                          (corner & 4) != 0 ? 1 : -1);
    points_W.push_back(ToWorld(X_WG, sign * half));
  }
}

/// Whether a body hangs on another, or is it.
bool BelongsTo(const mjModel& m, int body, int other) {
  while (body != other && body != 0) body = m.body_parentid[body];
  return body == other;
}

/// Of a free camera.
glm::dvec3 ForwardOf(const mjvCamera& camera) {
  const double a = camera.azimuth / kDegrees, e = camera.elevation / kDegrees;
  return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

/// At the middle of these points, so far that all are seen.
void StandBack(mjvCamera& camera, const std::vector<glm::dvec3>& points_W, const mjModel& m,
               double aspect) {
  if (points_W.empty()) return;
  glm::dvec3 low = points_W.front(), high = low;
  for (const glm::dvec3& p_W : points_W) {
    low = glm::min(low, p_W);
    high = glm::max(high, p_W);
  }
  const glm::dvec3 middle_W = 0.5 * (low + high);
  LookAt(camera, middle_W);
  const double a = camera.azimuth / kDegrees;
  const glm::dvec3 forward = ForwardOf(camera);
  const glm::dvec3 right(std::sin(a), -std::cos(a), 0), up = glm::cross(right, forward);
  const double tangent =
      kFilled * std::tan(0.5 * static_cast<double>(m.vis.global.fovy) / kDegrees);
  double distance = kNearest;
  for (const glm::dvec3& p_W : points_W) {
    const glm::dvec3 r = p_W - middle_W;
    const double wide =
        std::max(std::abs(glm::dot(r, up)), std::abs(glm::dot(r, right)) / aspect) / tangent;
    distance = std::max(distance, wide - glm::dot(r, forward));
  }
  camera.distance = std::min(distance, kFarthest);
}

/// Looks along -normal, a little from above and from the side, so that depth is seen; never so
/// steep that up and down change.
void Face(mjvCamera& camera, glm::dvec3 normal_W, glm::dvec3 up_W) {
  constexpr double kAside = 12, kAbove = 24, kSteepest = 62;  // [degrees]
  const double slope = -std::asin(std::clamp(normal_W.z, -1.0, 1.0)) * kDegrees;
  const bool upright = std::hypot(normal_W.x, normal_W.y) > 0.35;
  const glm::dvec3 along = upright ? -normal_W : (normal_W.z > 0 ? up_W : -up_W);
  camera.azimuth = std::atan2(along.y, along.x) * kDegrees + (upright ? kAside : 0);
  camera.elevation = std::clamp(slope - (slope > -kSteepest ? kAbove : 0), -kSteepest, kSteepest);
}

/// To where more of the label is seen, if something else stands before it.
void GoAround(const ViewModel& model, const mjData& d, const ViewModel::Label& label,
              const std::vector<glm::dvec3>& points_W, mjvCamera& camera, double aspect) {
  constexpr double kHidden = 0.3, kLittle = 0.1, kBetter = 0.1;  // of the label
  constexpr double kAside[] = {0, -25, 25, -50, 50, -75, 75};    // [degrees]
  constexpr double kAbove[] = {0, -20, -40, 20, 40};
  const auto shares_by = [&](const mjvCamera& from) {
    return SharesSeen(model, d, label, LookedAt(from) - from.distance * ForwardOf(from));
  };
  const mjvCamera first = camera;
  SeenShares best = shares_by(first);
  if (best.hidden <= kHidden) return;
  for (const double above : kAbove) {
    for (const double aside : kAside) {
      mjvCamera other = first;
      other.azimuth += aside;
      other.elevation = std::clamp(other.elevation + above, -80.0, 80.0);
      StandBack(other, points_W, *model.m, aspect);
      const SeenShares shares = shares_by(other);
      if (shares.seen < best.seen + kBetter) continue;
      best = shares;
      camera = other;
      if (best.hidden <= kLittle) return;
    }
  }
}

void FaceLabel(const ViewModel& model, const mjData& d, const ViewModel::Label& label,
               mjvCamera& camera, double aspect) {
  const mjModel& m = *model.m;
  const Pose X_WG = PoseOfGeom(d, label.geom);
  const bool known = label.text_P.min.x <= label.text_P.max.x;
  const glm::dvec2 middle =
      known ? 0.5 * (label.text_P.min + label.text_P.max) : label.chart.place().on_page;
  const glm::dvec3 p_O = label.chart.ToObject({middle, 0});
  const LabelChart::Point at = label.chart.At(p_O);
  Face(camera, TurnToWorld(X_WG, label.chart.Above(p_O).normal_O),
       TurnToWorld(X_WG, glm::normalize(at.dy_O)));
  const Box text_P = known ? label.text_P : Grown(Box{middle, middle}, 0.04);
  const double text = 0.5 * glm::length(text_P.max - text_P.min);
  const double geom = RadiusOf(m, label.geom);
  std::vector<glm::dvec3> points_W;
  if (geom > 0 && geom <= kMostOfGeom * text) {
    AddCorners(m, d, label.geom, points_W);
  } else {
    for (const glm::dvec2 share :
         {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(1, 1)}) {
      const glm::dvec2 p_P = text_P.min + share * (text_P.max - text_P.min);
      points_W.push_back(ToWorld(X_WG, label.chart.ToObject({p_P, 0})));
    }
  }
  StandBack(camera, points_W, m, aspect);
  GoAround(model, d, label, points_W, camera, aspect);
}

}  // namespace

mjvCamera WholeModel(const mjModel& m) {
  mjvCamera camera;
  mjv_defaultCamera(&camera);
  mjv_defaultFreeCamera(&m, &camera);
  return camera;
}

void LookAt(mjvCamera& camera, glm::dvec3 p_W) {
  for (int i = 0; i < 3; ++i) camera.lookat[i] = p_W[i];
}

mjvCamera CameraOn(const ViewModel& model, const mjData& d, const ViewTarget& target,
                   const mjvCamera& now, glm::dvec3 tip_W, double aspect) {
  using Kind = ViewTarget::Kind;
  const mjModel& m = *model.m;
  mjvCamera camera = now;
  if (target.kind == Kind::kCamera) {
    camera.type = mjCAMERA_FIXED;
    camera.fixedcamid = target.number;
    return camera;
  }
  if (camera.type != mjCAMERA_FREE) camera = WholeModel(m);
  std::vector<glm::dvec3> points_W;
  switch (target.kind) {
    case Kind::kWhole:
      return WholeModel(m);
    case Kind::kTip:
      LookAt(camera, tip_W);
      break;
    case Kind::kLabel:
      FaceLabel(model, d, model.labels[static_cast<std::size_t>(target.number)], camera, aspect);
      break;
    case Kind::kGeom:
      LookAt(camera, PlaceOf(d, target.number));
      AddCorners(m, d, target.number, points_W);
      break;
    case Kind::kBody:
      for (int geom = 0; geom < static_cast<int>(m.ngeom); ++geom) {
        if (BelongsTo(m, m.geom_bodyid[geom], target.number)) AddCorners(m, d, geom, points_W);
      }
      break;
    case Kind::kCamera:
      break;
  }
  StandBack(camera, points_W, m, aspect);
  return camera;
}

mjvCamera Freed(const mjvCamera& camera, const Sight& sight, double distance) {
  if (camera.type == mjCAMERA_FREE) return camera;
  mjvCamera free = camera;
  free.type = mjCAMERA_FREE;
  free.distance = std::clamp(distance, kNearest, kFarthest);
  free.azimuth = std::atan2(sight.forward_W.y, sight.forward_W.x) * kDegrees;
  free.elevation = std::asin(std::clamp(sight.forward_W.z, -1.0, 1.0)) * kDegrees;
  LookAt(free, sight.eye_W + free.distance * sight.forward_W);
  return free;
}

void Turn(mjvCamera& camera, glm::dvec2 by) {
  constexpr double kHalfTurn = 180, kSteepest = 89;  // [degrees]
  camera.azimuth -= kHalfTurn * by.x;
  camera.elevation = std::clamp(camera.elevation + kHalfTurn * by.y, -kSteepest, kSteepest);
}

void Shift(mjvCamera& camera, const Sight& sight, glm::dvec2 by) {
  const glm::dvec3 at = LookedAt(camera);
  LookAt(camera, at - sight.HeightAt(at) * (by.x * sight.right_W + by.y * sight.up_W));
}

void Zoom(mjvCamera& camera, const Sight& sight, glm::dvec2 share, double factor) {
  const glm::dvec3 at = LookedAt(camera);
  const double before = camera.distance;
  camera.distance = std::clamp(before * factor, kNearest, kFarthest);
  const Sight::Ray ray = sight.RayUnder(share);
  const double slant = glm::dot(ray.along_W, sight.forward_W);
  const double depth = sight.DepthOf(at);
  const glm::dvec3 under = ray.from_W + depth / std::max(slant, 0.1) * ray.along_W;
  LookAt(camera, at + (1 - camera.distance / before) * (under - at));
}

}  // namespace moontrace
