#include "sim/model_view/label_relief.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "sim/physics/mujoco_compat.h"

namespace moontrace {

namespace {

constexpr double kMostPoints = 600000;  // of a grid
constexpr double kCoarsest = 0.25e-3;   // step: no groove falls between two points [m]
constexpr double kFinest = 5e-6;        // [m]
constexpr int kLook = 24;               // points along a side of the area, looked at
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

bool IsFlat(const Sample& sample) {
  return std::abs(sample.displacement) < 1e-9 && glm::dot(sample.gradient, sample.gradient) < 1e-12;
}

/// Gathers what is seen.
struct Looked {
  Box seen_P;
  double finest = std::numeric_limits<double>::infinity();  // of the world, of a picture point [m]

  void Add(const Box& part_P, double point) {
    Include(seen_P, part_P);
    finest = std::min(finest, point);
  }
};

/// From the label: what of it is in the picture.
void LookFromLabel(const LabelChart& chart, const Box& area_P, const Pose& X_WG, const Sight& sight,
                   int height, Looked& looked) {
  constexpr double kBeside = 0.02;  // of the picture
  const glm::dvec2 cell = (area_P.max - area_P.min) / static_cast<double>(kLook);
  for (int i = 0; i <= kLook; ++i) {
    for (int k = 0; k <= kLook; ++k) {
      const glm::dvec2 p_P = area_P.min + glm::dvec2(i, k) * cell;
      const glm::dvec3 p_O = chart.ToObject({p_P, 0});
      const glm::dvec3 p_W = ToWorld(X_WG, p_O);
      const glm::dvec3 normal_W = TurnToWorld(X_WG, chart.Above(p_O).normal_O);
      if (glm::dot(normal_W, sight.ToEye(p_W)) <= 0) continue;
      const auto share = sight.ShareOf(p_W);
      if (!share || share->x < -kBeside || share->y < -kBeside || share->x > 1 + kBeside ||
          share->y > 1 + kBeside) {
        continue;
      }
      looked.Add(Box{p_P - cell, p_P + cell}, sight.HeightAt(p_W) / height);
    }
  }
}

/// Where a ray enters a solid, by its surface's heights: sphere tracing.
std::optional<glm::dvec3> Entry(const Solid& solid, glm::dvec3 from_O, glm::dvec3 along_O) {
  constexpr int kSteps = 96;
  constexpr double kThere = 1e-6, kFar = 1e3;  // [m]
  double far = 0;
  for (int i = 0; i < kSteps && far < kFar; ++i) {
    const glm::dvec3 p_O = from_O + far * along_O;
    const double height = NearestOf(solid, p_O).height;
    if (height < kThere) return p_O;
    far += height;
  }
  return std::nullopt;
}

/// From the eye: where the label is so near that the picture lies between two points of it.
void LookFromEye(const LabelChart& chart, const Solid& solid, const Box& area_P, const Pose& X_WG,
                 const Sight& sight, int height, Looked& looked) {
  constexpr int kRays = 8;
  for (int i = 0; i <= kRays; ++i) {
    for (int k = 0; k <= kRays; ++k) {
      const Sight::Ray ray = sight.RayUnder(glm::dvec2(i, k) / static_cast<double>(kRays));
      const auto at_O = Entry(solid, FromWorld(X_WG, ray.from_W), TurnFromWorld(X_WG, ray.along_W));
      if (!at_O) continue;
      const glm::dvec2 p_P = chart.At(*at_O).p_P;
      const double across = sight.HeightAt(ToWorld(X_WG, *at_O)) / kRays;
      const Box part_P = Grown(Box{p_P, p_P}, 2 * across);
      if (!Overlap(part_P, area_P) || chart.Above(*at_O).height > 1e-3) continue;
      looked.Add(part_P, across * kRays / height);
    }
  }
}

/// Light that falls on a point from one direction, without what material makes of it.
struct Beam {
  glm::vec3 to_light{0, 0, 1};
  glm::vec3 color{0, 0, 0};
};

/// As OpenGL has it.
Beam BeamOf(const mjvLight& light, glm::vec3 p_W) {
  const glm::vec3 direction = glm::normalize(glm::vec3(light.dir[0], light.dir[1], light.dir[2]));
  const glm::vec3 color(light.diffuse[0], light.diffuse[1], light.diffuse[2]);
  if (IsDirectional(light)) return {-direction, color};
  const glm::vec3 way = glm::vec3(light.pos[0], light.pos[1], light.pos[2]) - p_W;
  const float far = std::max(glm::length(way), 1e-6F);
  const glm::vec3 to_light = way / far;
  const float* a = light.attenuation;
  float strength = 1 / std::max(a[0] + a[1] * far + a[2] * far * far, 1e-6F);
  constexpr float kWidestSpot = 90;
  if (light.cutoff <= kWidestSpot) {
    const float inside = glm::dot(-to_light, direction);
    const float edge = std::cos(light.cutoff * std::numbers::pi_v<float> / 180);
    strength *= inside < edge ? 0 : std::pow(std::max(inside, 0.0F), light.exponent);
  }
  return {to_light, strength * color};
}

/// From 0 to 1: roughness of paper stays paper, and a line is darkest along its middle.
float TintShare(float depth) {
  constexpr float kFrom = 0.15F, kFull = 0.95F;
  const float t = std::clamp((std::abs(depth) - kFrom) / (kFull - kFrom), 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

}  // namespace

std::optional<ReliefArea> SeenOf(const LabelChart& chart, const Solid& solid, const Box& area_P,
                                 const Pose& X_WG, const Sight& sight, int height) {
  Looked looked;
  LookFromLabel(chart, area_P, X_WG, sight, height, looked);
  LookFromEye(chart, solid, area_P, X_WG, sight, height, looked);
  ReliefArea area;
  area.box_P = {glm::max(looked.seen_P.min, area_P.min), glm::min(looked.seen_P.max, area_P.max)};
  const glm::dvec2 size = area.box_P.max - area.box_P.min;
  if (!(size.x > 0 && size.y > 0)) return std::nullopt;
  area.step = std::clamp(looked.finest, kFinest, kCoarsest);
  area.step = std::max(area.step, std::sqrt(size.x * size.y / kMostPoints));
  return area;
}

bool Serves(const ReliefArea& made, const ReliefArea& wanted) {
  const bool fine = made.step <= 1.25 * wanted.step && made.step >= 0.4 * wanted.step;
  return fine && Contains(made.box_P, wanted.box_P.min) && Contains(made.box_P, wanted.box_P.max);
}

LabelRelief MakeRelief(const LabelChart& chart, const TextureField& field, const ReliefArea& area,
                       double lift) {
  LabelRelief relief;
  relief.of = area;
  const glm::dvec2 size = area.box_P.max - area.box_P.min;
  const auto across = static_cast<std::size_t>(std::ceil(size.x / area.step)) + 1;
  const auto up = static_cast<std::size_t>(std::ceil(size.y / area.step)) + 1;
  const double greatest = std::max(field.greatest_displacement(), 1e-12);
  std::vector<glm::dvec2> row_P(across);
  std::vector<Sample> below(across), row(across);
  std::vector<std::uint32_t> below_points(across, kNone), row_points(across, kNone);
  const auto point_at = [&](std::size_t i, double y, const Sample& sample,
                            std::vector<std::uint32_t>& numbers) {
    if (numbers[i] != kNone) return numbers[i];
    const glm::dvec2 p_P(row_P[i].x, y);
    const glm::dvec3 p_O = chart.ToObject({p_P, lift + std::max(sample.displacement, 0.0)});
    const LabelChart::Point at = chart.At(p_O);
    const glm::dvec3 smooth_O = chart.Above(p_O).normal_O;
    const glm::dvec3 slope_O = sample.gradient.x * at.dx_O + sample.gradient.y * at.dy_O;
    ReliefPoint point;
    point.p_O = glm::vec3(p_O);
    point.smooth_O = glm::vec3(smooth_O);
    point.relief_O = glm::vec3(glm::normalize(smooth_O - slope_O));
    point.depth = static_cast<float>(sample.displacement / greatest);
    relief.points.push_back(point);
    numbers[i] = static_cast<std::uint32_t>(relief.points.size() - 1);
    return numbers[i];
  };
  for (std::size_t k = 0; k < up; ++k) {
    const double y = area.box_P.min.y + area.step * static_cast<double>(k);
    for (std::size_t i = 0; i < across; ++i) {
      row_P[i] = {area.box_P.min.x + area.step * static_cast<double>(i), y};
    }
    field.SamplesAt(row_P, row);
    std::fill(row_points.begin(), row_points.end(), kNone);
    for (std::size_t i = 0; k > 0 && i + 1 < across; ++i) {
      if (IsFlat(below[i]) && IsFlat(below[i + 1]) && IsFlat(row[i]) && IsFlat(row[i + 1])) {
        continue;
      }
      const std::uint32_t a = point_at(i, y - area.step, below[i], below_points);
      const std::uint32_t b = point_at(i + 1, y - area.step, below[i + 1], below_points);
      const std::uint32_t c = point_at(i, y, row[i], row_points);
      const std::uint32_t e = point_at(i + 1, y, row[i + 1], row_points);
      relief.triangles.insert(relief.triangles.end(), {a, b, c, b, e, c});
    }
    std::swap(below, row);
    std::swap(below_points, row_points);
  }
  return relief;
}

ReliefTint TintFor(double luminance, bool high_contrast) {
  constexpr double kDark = 0.22;
  ReliefTint tint;
  if (high_contrast) tint = {glm::vec3(0.05F), {0.45F, 0.2F, 0.05F}};
  if (luminance < kDark) tint = {glm::vec3(1.9F), glm::vec3(2)};
  return tint;
}

void ShadeRelief(const LabelRelief& relief, const Pose& X_WG, const Sight& sight, bool reversed,
                 std::span<const mjvLight> lights, double emission, const ReliefTint& tint,
                 std::vector<DrawnPoint>& drawn, std::vector<std::uint32_t>& triangles) {
  constexpr double kLift = 3e-4;  // towards the eye, of the distance: before the geom itself
  drawn.resize(relief.points.size());
  std::vector<std::uint8_t> faces(relief.points.size());
  glm::vec3 everywhere(static_cast<float>(emission));
  for (const mjvLight& light : lights) {
    everywhere += glm::vec3(light.ambient[0], light.ambient[1], light.ambient[2]);
  }
  const glm::mat3 R_WG(X_WG.R);
  for (std::size_t i = 0; i < relief.points.size(); ++i) {
    const ReliefPoint& point = relief.points[i];
    const glm::dvec3 p_W = ToWorld(X_WG, glm::dvec3(point.p_O));
    const glm::vec3 smooth_W = R_WG * point.smooth_O, relief_W = R_WG * point.relief_O;
    faces[i] = glm::dot(glm::dvec3(smooth_W), sight.ToEye(p_W)) > 0 ? 1 : 0;
    glm::vec3 smooth = everywhere, textured = everywhere;
    for (const mjvLight& light : lights) {
      const Beam beam = BeamOf(light, glm::vec3(p_W));
      smooth += std::max(glm::dot(smooth_W, beam.to_light), 0.0F) * beam.color;
      textured += std::max(glm::dot(relief_W, beam.to_light), 0.0F) * beam.color;
    }
    // OpenGL keeps no more than white
    const glm::vec3 lit = glm::min(textured, 1.0F) / glm::max(glm::min(smooth, 1.0F), 0.02F);
    const glm::vec3 deep =
        glm::mix(glm::vec3(1), point.depth < 0 ? tint.groove : tint.ridge, TintShare(point.depth));
    const glm::vec3 factor = glm::clamp(0.5F * lit * deep, 0.0F, 1.0F);
    const glm::dvec4 clip = sight.ClipOf(p_W + kLift * (sight.eye_W - p_W), reversed);
    for (int axis = 0; axis < 4; ++axis) drawn[i].clip[axis] = static_cast<float>(clip[axis]);
    for (int axis = 0; axis < 3; ++axis) drawn[i].factor[axis] = factor[axis];
  }
  triangles.clear();
  for (std::size_t i = 0; i + 2 < relief.triangles.size(); i += 3) {
    const std::uint32_t* t = &relief.triangles[i];
    if ((faces[t[0]] & faces[t[1]] & faces[t[2]]) != 0) triangles.insert(triangles.end(), t, t + 3);
  }
}

}  // namespace moontrace
