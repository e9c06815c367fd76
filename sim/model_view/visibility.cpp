#include "sim/model_view/visibility.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "sim/physics/felt_object.h"

namespace moontrace {

namespace {

constexpr int kAcross = 12, kUp = 4;  // points of a label that are looked for
constexpr double kSlant = 0.12;       // what is turned farther away is not read

}  // namespace

int HiddenBy(const ViewModel& model, const mjData& d, const ViewModel::Label& label,
             glm::dvec3 eye_W, glm::dvec3 p_W) {
  constexpr double kNear = 0.03;  // of the way: round geoms are drawn with flat facets
  const glm::dvec3 way = p_W - eye_W;
  const double from[3] = {eye_W.x, eye_W.y, eye_W.z}, along[3] = {way.x, way.y, way.z};
  const RayHit hit = FirstOnRay(*model.m, d, from, along);
  const bool own = hit.geom == label.geom || hit.geom == label.drawn;
  if (hit.geom < 0 || own || hit.distance > 1 - kNear) return -1;
  const int body = model.m->geom_bodyid[hit.geom];
  return body == model.proxy_body || body == model.handle_body ? -1 : hit.geom;
}

bool LabelPoint::IsTurnedFrom(glm::dvec3 eye_W) const {
  return glm::dot(normal_W, glm::normalize(eye_W - p_W)) < kSlant;
}

std::vector<LabelPoint> PointsOf(const ViewModel::Label& label, const mjData& d) {
  std::vector<LabelPoint> points;
  if (!(label.text_P.min.x <= label.text_P.max.x)) return points;
  points.reserve(std::size_t{kAcross} * kUp);
  const Pose X_WG = PoseOfGeom(d, label.geom);
  for (int i = 0; i < kAcross; ++i) {
    for (int k = 0; k < kUp; ++k) {
      const glm::dvec2 share((i + 0.5) / kAcross, (k + 0.5) / kUp);
      const glm::dvec2 p_P = label.text_P.min + share * (label.text_P.max - label.text_P.min);
      const glm::dvec3 p_O = label.chart.ToObject({p_P, 0});
      points.push_back({ToWorld(X_WG, p_O), TurnToWorld(X_WG, label.chart.Above(p_O).normal_O)});
    }
  }
  return points;
}

SeenShares SharesSeen(const ViewModel& model, const mjData& d, const ViewModel::Label& label,
                      glm::dvec3 eye_W) {
  const std::vector<LabelPoint> points = PointsOf(label, d);
  SeenShares shares;
  const double each = 1 / std::max(1.0, static_cast<double>(points.size()));
  for (const LabelPoint& point : points) {
    if (point.IsTurnedFrom(eye_W)) continue;
    (HiddenBy(model, d, label, eye_W, point.p_W) < 0 ? shares.seen : shares.hidden) += each;
  }
  return shares;
}

}  // namespace moontrace
