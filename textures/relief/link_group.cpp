// A link's elements on the page.
#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "textures/relief/groove_links.h"

namespace moontrace {
namespace {

constexpr double kRamp = 1.5;        // length over which it becomes shallow [w]
constexpr double kShortestRamp = 1;  // below this a ramp is steeper than a flank [w]

/// How a link's profile is along its way, as q of Fade: level, ramp, level, ramp, level.
struct DepthAlong {
  double at[4] = {0, 0, 0, 0};  ///< where ramps begin and end [m]
  double least = 1;

  double ShareAt(double s) const {
    if (s <= at[0] || s >= at[3]) return 1;
    if (s >= at[1] && s <= at[2]) return least;
    const double u = s < at[1] ? (s - at[0]) / (at[1] - at[0]) : (at[3] - s) / (at[3] - at[2]);
    return 1 + u * (least - 1);
  }
};

DepthAlong DepthOf(const LinkShape& shape, const TypeStyle& style, double length) {
  const double w = style.width, ramp = kRamp * w;
  const double wanted = shape.from_level + shape.to_level + 2 * ramp;
  const double scale = std::min(1.0, length / wanted);
  DepthAlong depth;
  depth.at[0] = scale * shape.from_level;
  depth.at[1] = depth.at[0] + scale * ramp;
  depth.at[3] = length - scale * shape.to_level;
  depth.at[2] = std::max(depth.at[3] - scale * ramp, depth.at[1]);
  depth.least = scale * ramp < kShortestRamp * w ? 1 : std::sqrt(style.links.depth);
  return depth;
}

}  // namespace

Group BuildLink(const LinkShape& shape, const TypeStyle& style) {
  const double length = Length(shape.spine);
  const DepthAlong depth = DepthOf(shape, style, length);
  const auto profile = [&style](double q) {
    return Profile{q * style.width, q * q * style.depth, q * style.rounding};
  };
  Group group;
  double begin = 0;
  for (const Piece& piece : shape.spine) {
    const double own = Length(piece);
    std::vector<double> cuts = {0};
    for (const double at : depth.at) {
      if (at - begin > cuts.back() + 1e-9 * length && at - begin < own * (1 - 1e-9))
        cuts.push_back(at - begin);
    }
    cuts.push_back(own);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const Piece part = PartBetween(piece, cuts[i], cuts[i + 1]);
      const double from = depth.ShareAt(begin + cuts[i]), to = depth.ShareAt(begin + cuts[i + 1]);
      Element element{Dot{}, profile(from == to ? from : 1), {}};
      std::visit([&element](const auto& line_or_arc) { element.shape = line_or_arc; }, part);
      if (from != to) element.fade = {from, to};
      group.elements.push_back(element);
      // rounding leaves hairs between pieces that a cap covers
      group.elements.push_back({Dot{StartOf(part)}, profile(from), {}});
    }
    begin += own;
  }
  if (!shape.spine.empty()) {
    group.elements.push_back({Dot{EndOf(shape.spine.back())}, profile(depth.ShareAt(length)), {}});
  }
  return group;
}

}  // namespace moontrace
