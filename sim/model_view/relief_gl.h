#pragma once

#include <mujoco/mujoco.h>

#include <cstdint>
#include <vector>

#include "sim/model_view/label_relief.h"

namespace moontrace {

/// Whether what MuJoCo drew last in the current OpenGL context has its depths from 1, near, to 0.
bool DepthIsReversed();

/// Behind MuJoCo's drawing, which leaves its shadows' texture in use: others draw without it.
void LeaveNoTexture();

/// Multiplies what MuJoCo drew there by the points' factors, wherever nothing stands before.
void DrawRelief(const std::vector<DrawnPoint>& points, const std::vector<std::uint32_t>& triangles,
                mjrRect rect);

}  // namespace moontrace
