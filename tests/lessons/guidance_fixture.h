#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "lessons/guide/guidance.h"
#include "lessons/guide/guidance_path.h"

namespace moontrace {

inline constexpr double kGuideTick = 1e-3;     ///< [s]
inline constexpr double kGuideWidth = 0.0014;  ///< [m]
inline constexpr double kSlidePerTick = 1e-4;  ///< of a target while the tip rests, guidance.h [m]

inline IntendedStroke GuideStroke(std::vector<Piece> spine, std::size_t glyph = 0) {
  IntendedStroke stroke;
  stroke.spine_P = std::move(spine);
  stroke.width = kGuideWidth;
  stroke.glyph = glyph;
  return stroke;
}

/// A plan of a mode with plain gains.
inline GuidancePlan GuidePlan(GuidanceMode mode, const std::vector<IntendedStroke>& strokes) {
  GuidancePlan plan;
  plan.mode = mode;
  plan.gains.stiffness = 200;
  plan.gains.cap = 1.5;
  plan.gains.leash_widths = 2;
  plan.path = MakeGuidancePath(strokes);
  return plan;
}

/// Holds the tip for some ticks; the last result.
inline GuidanceResult HoldTip(const GuidancePlan& plan, GuidanceState& state, glm::dvec2 p,
                              int ticks) {
  GuidanceResult result;
  for (int i = 0; i < ticks; ++i) result = Guide(plan, state, {p, 0}, {0, 0, 0}, kGuideTick);
  return result;
}

/// Moves the tip evenly along a line in `ticks` ticks; the last result.
inline GuidanceResult MoveTip(const GuidancePlan& plan, GuidanceState& state, glm::dvec2 from,
                              glm::dvec2 to, int ticks) {
  GuidanceResult result;
  for (int i = 1; i <= ticks; ++i) {
    result = Guide(plan, state, {from + (to - from) * (static_cast<double>(i) / ticks), 0},
                   {0, 0, 0}, kGuideTick);
  }
  return result;
}

/// A hand without a will: a mass with damping that the push alone moves.
struct PassiveHand {
  glm::dvec2 p{0, 0}, v{0, 0};
  double mass = 0.1, damping = 3;  // as devices/hand.toml
  void Push(glm::dvec3 force) {
    v += (glm::dvec2(force) - damping * v) / mass * kGuideTick;
    p += v * kGuideTick;
  }
};

}  // namespace moontrace
