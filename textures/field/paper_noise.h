#pragma once

#include <cstring>
#include <glm/vec2.hpp>

#include "textures/field/in_box.h"
#include "textures/field/paper_field.h"
#include "textures/field/paper_shape.h"

/// Rough paper as a query meets it, all inline: it runs in the tick.
namespace moontrace {

/// Two numbers side by side, as x and y are: baseline processors reckon with both at once.
using Two = double __attribute__((vector_size(16)));
/// What stands in memory in one go.
inline Two LoadTwo(const glm::dvec2& v) noexcept {
  Two both;
  std::memcpy(&both, &v, sizeof both);
  return both;
}

/// Of a patch of noise at a place from its lower left corner.
inline Sample OfNoise(const FlatPatch& patch, glm::dvec2 p) noexcept {
  const Two uv = Two{p.x, p.y} * patch.wave.x;
  // the patch begins at zero, so that cutting is rounding down
  const auto column = static_cast<std::int32_t>(uv[0]), row = static_cast<std::int32_t>(uv[1]);
  const Two in = uv - Two{static_cast<double>(column), static_cast<double>(row)};  // the cell
  const Two beyond = in - 1.0;
  const std::uint32_t mixed = static_cast<std::uint32_t>(column) * kHashColumn +
                              static_cast<std::uint32_t>(row) * kHashRow + patch.seed;
  const Two a = LoadTwo(LatticeDirection(mixed));
  const Two b = LoadTwo(LatticeDirection(mixed + kHashColumn));
  const Two c = LoadTwo(LatticeDirection(mixed + kHashRow));
  const Two d = LoadTwo(LatticeDirection(mixed + kHashColumn + kHashRow));
  const Two share = in * in * in * (in * (6.0 * in - 15.0) + 10.0);
  const Two rate = 30.0 * in * in * (1.0 - in) * (1.0 - in);
  // the four corners' planes, blended along x below and above, then along y
  const Two at_a = a * in, at_b = b * Two{beyond[0], in[1]};
  const Two at_c = c * Two{in[0], beyond[1]}, at_d = d * beyond;
  const Two left = Two{at_a[0], at_c[0]} + Two{at_a[1], at_c[1]};
  const Two right = Two{at_b[0], at_d[0]} + Two{at_b[1], at_d[1]};
  const Two rise = right - left, height = left + share[0] * rise;  // each below and above
  const Two by_share = rate[0] * rise;
  const Two below = a + share[0] * (b - a) + Two{by_share[0], 0};
  const Two above = c + share[0] * (d - c) + Two{by_share[1], 0};
  const double up = height[1] - height[0];
  const Two gradient = below + share[1] * (above - below) + Two{0, rate[1] * up};
  const double slope = patch.amplitude * patch.wave.x;
  return {patch.amplitude * (height[0] + share[1] * up),
          {slope * gradient[0], slope * gradient[1]}};
}

/// PaperField::SampleAt, with the way that nearly every query takes inline: one rough sheet, away
/// from its edges.
inline Sample SamplePaper(const PaperField& paper, glm::dvec2 p_P) noexcept {
  const FlatPatch& patch = paper.patches().front();
  if (paper.patches().size() == 1 && patch.kind == PaperKind::kNoise && IsIn(patch.core, p_P)) {
    return OfNoise(patch, {p_P.x - patch.box.min.x, p_P.y - patch.box.min.y});
  }
  return paper.SampleAt(p_P);
}

}  // namespace moontrace
