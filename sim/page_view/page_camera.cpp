#include "sim/page_view/page_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace moontrace {

namespace {

constexpr double kNearest = 0.002, kFarthest = 2;  // heights of page in view [m]
constexpr double kMostHeights = 8;                 // seen each way of a page that leans far

}  // namespace

double EyeDistance(const PageCamera& camera) {
  return 0.5 * camera.height / std::tan(0.5 * kFieldOfView);
}

glm::dvec2 PointUnder(const PageCamera& camera, double aspect, glm::dvec2 share) {
  const double sine = std::sin(camera.lean), cosine = std::cos(camera.lean);
  const double distance = EyeDistance(camera);
  // the picture's plane through the point in its middle: to the right, up, and from the eye
  const double across = (share.x - 0.5) * camera.height * aspect;
  const double up = (share.y - 0.5) * camera.height;
  const glm::dvec3 eye(0, -distance * sine, distance * cosine);
  const glm::dvec3 through(across, up * cosine, up * sine);
  const glm::dvec3 ray = through - eye;
  // beyond the horizon nothing of the page is seen: as far as VisibleBox goes
  const double farthest = kMostHeights * camera.height;
  const double reach = ray.z < 0 ? std::min(-eye.z / ray.z, 1e3) : 1e3;
  const glm::dvec2 from = glm::dvec2(eye) + reach * glm::dvec2(ray);
  return camera.at_P + glm::clamp(from, -farthest, farthest);
}

std::optional<glm::dvec2> ShareOf(const PageCamera& camera, double aspect, glm::dvec3 p_P) {
  const double sine = std::sin(camera.lean), cosine = std::cos(camera.lean);
  const double distance = EyeDistance(camera);
  const glm::dvec3 eye(0, -distance * sine, distance * cosine);
  const glm::dvec3 ray = p_P - glm::dvec3(camera.at_P, 0) - eye;
  const double depth = ray.y * sine - ray.z * cosine;
  if (depth <= 0) return std::nullopt;
  const double up = (ray.y * cosine + ray.z * sine) * distance / depth;
  const double across = ray.x * distance / depth;
  return glm::dvec2(0.5 + across / (camera.height * aspect), 0.5 + up / camera.height);
}

Box VisibleBox(const PageCamera& camera, double aspect) {
  Box box;
  for (const glm::dvec2 corner :
       {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(1, 1)}) {
    Include(box, PointUnder(camera, aspect, corner));
  }
  return box;
}

PageCamera Zoomed(const PageCamera& camera, double aspect, glm::dvec2 share, double factor) {
  PageCamera zoomed = camera;
  zoomed.height = std::clamp(camera.height * factor, kNearest, kFarthest);
  const glm::dvec2 before = PointUnder(camera, aspect, share);
  zoomed.at_P += before - PointUnder(zoomed, aspect, share);
  return zoomed;
}

PageCamera CameraOn(const Box& box_P, double aspect, double lean) {
  PageCamera camera;
  camera.at_P = 0.5 * (box_P.min + box_P.max);
  const glm::dvec2 size = box_P.max - box_P.min;
  camera.height = std::clamp(std::max(size.y, size.x / aspect), kNearest, kFarthest);
  camera.lean = lean;
  return camera;
}

}  // namespace moontrace
