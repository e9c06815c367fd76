#include "textures/field/texture.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "textures/base/overload.h"
#include "textures/field/blend.h"

namespace moontrace {

namespace {

bool CanBlend(const Element& element) {
  if (!element.fade.IsNone()) return false;
  return std::visit(Overload{[](const Line&) { return true; }, [](const Arc&) { return true; },
                             [](const Dot&) { return false; }, [](const Fill&) { return false; }},
                    element.shape);
}

Foot FootOnLine(const Line& line, glm::dvec2 p) {
  Foot foot{.distance = -1};
  const double length = glm::length(line.to - line.from);
  if (length == 0) return foot;
  const glm::dvec2 unit = (line.to - line.from) / length;
  const double t = glm::dot(p - line.from, unit);
  if (t < 0 || t > length) return foot;
  const glm::dvec2 v = p - line.from - t * unit;
  foot.distance = glm::length(v);
  if (foot.distance > 0) foot.gradient = v / foot.distance;
  foot.inset = std::min(t, length - t);
  foot.inset_gradient = t <= length - t ? unit : -unit;
  return foot;
}

Foot FootOnArc(const Arc& arc, glm::dvec2 p) {
  Foot foot{.distance = -1};
  const glm::dvec2 v = p - arc.center;
  const double distance = glm::length(v);
  if (distance == 0) return foot;
  const double sense = arc.sweep < 0 ? -1 : 1;
  const double along = AngleAlong(arc, v), sweep = std::abs(arc.sweep);
  if (!IsWhole(arc) && along > sweep) return foot;
  foot.distance = std::abs(distance - arc.radius);
  if (foot.distance > 0) foot.gradient = (distance < arc.radius ? -1.0 : 1.0) / distance * v;
  if (IsWhole(arc)) {
    foot.inset = std::numeric_limits<double>::max();
    return foot;
  }
  const bool near_start = along <= sweep - along;
  const double angle = near_start ? along : sweep - along;
  const glm::dvec2 outward = v / distance;
  const glm::dvec2 onward = (near_start ? sense : -sense) * glm::dvec2(-outward.y, outward.x);
  foot.inset = std::min(arc.radius, distance) * angle;
  foot.inset_gradient =
      distance < arc.radius ? onward + angle * outward : arc.radius / distance * onward;
  return foot;
}

Foot FootOf(const Shape& shape, glm::dvec2 p) {
  return std::visit(Overload{[p](const Line& line) { return FootOnLine(line, p); },
                             [p](const Arc& arc) { return FootOnArc(arc, p); },
                             [](const Dot&) { return Foot{.distance = -1}; },
                             [](const Fill&) { return Foot{.distance = -1}; }},
                    shape);
}

/// Magnitude of the group's element `i`, its creases with the group's others rounded.
Magnitude BlendedMagnitude(const Group& group, std::size_t i, glm::dvec2 p) {
  std::vector<Foot> feet(group.elements.size(), Foot{.distance = -1});
  for (std::size_t j = 0; j < feet.size(); ++j) {
    const Element& element = group.elements[j];
    feet[j] = FootOf(element.shape, p);
    const Profile &a = element.profile, &b = group.elements[i].profile;
    const bool same = a.width == b.width && a.depth == b.depth && a.rounding == b.rounding;
    if (!same || !CanBlend(element)) {
      feet[j].distance = -1;
    }
  }
  if (feet[i].distance < 0) return {};
  const BlendedDistance blended = Blend(feet, feet.size(), i, group.blend_radius);
  const ProfileSample sample = Evaluate(group.elements[i].profile, std::max(blended.distance, 0.0));
  return {sample.height, sample.slope * blended.gradient};
}

Magnitude SampleGroup(const Group& group, glm::dvec2 p) {
  if (!Contains(group.bounds, p)) return {};
  Magnitude greatest;
  const auto take = [&greatest](const Magnitude& member) {
    if (member.height > greatest.height) greatest = member;
  };
  for (std::size_t i = 0; i < group.elements.size(); ++i) {
    const bool blend = group.blend_radius > 0 && CanBlend(group.elements[i]);
    take(blend ? BlendedMagnitude(group, i, p) : Evaluate(group.elements[i], p));
  }
  for (const Placement& placement : group.placements) {
    take(SampleGroup(*placement.group, p - placement.origin));
  }
  return greatest;
}

}  // namespace

std::shared_ptr<const Group> Finish(Group group) {
  const auto members = static_cast<std::size_t>(
      std::count_if(group.elements.begin(), group.elements.end(), CanBlend));
  const double reach = BlendReach(members, group.blend_radius);
  group.bounds = Box{};
  for (const Element& element : group.elements) {
    Include(group.bounds, Grown(BoundsOf(element), reach));
  }
  for (const Placement& placement : group.placements) {
    const Box& member = placement.group->bounds;
    if (member.min.x <= member.max.x) Include(group.bounds, Moved(member, placement.origin));
  }
  return std::make_shared<const Group>(std::move(group));
}

Sample SampleTree(const Texture& texture, glm::dvec2 p_P) {
  Sample sum;
  for (const Layer& layer : texture.layers) {
    const Magnitude magnitude = SampleGroup(*layer.group, p_P);
    const double sign = layer.relief == Relief::kEngraved ? -1 : 1;
    sum.displacement += sign * magnitude.height;
    sum.gradient += sign * magnitude.gradient;
  }
  for (const PaperPatch& patch : texture.paper) {
    const Sample sample = Evaluate(patch, p_P);
    sum.displacement += sample.displacement;
    sum.gradient += sample.gradient;
  }
  return sum;
}

}  // namespace moontrace
