#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <random>

#include "textures/field/field.h"

namespace moontrace {

/// Along 300 random ways of 3 mm over a page of `size` [m], in steps of 1 um: displacement changes
/// by no more than the greatest slope allows, and off creases the gradient is the derivative.
/// `felt` points at least lie where the paper is not flat; only these are judged.
inline void ExpectGradientIsTheDerivative(const TextureField& field, glm::dvec2 size, int felt) {
  constexpr double kStep = 1e-6, kSmall = 1e-9;
  const double steepest = 2 * field.greatest_slope();  // blending adds two flanks at most
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> x(0, size.x), y(0, size.y), turn(0, 6.283);
  int wrong = 0, count = 0;
  for (int line = 0; line < 300; ++line) {
    const double angle = turn(random);
    const glm::dvec2 way(std::cos(angle), std::sin(angle));
    glm::dvec2 p(x(random), y(random));
    double before = field.SampleAt(p).displacement;
    for (int i = 0; i < 3000; ++i) {
      p += kStep * way;
      const Sample sample = field.SampleAt(p);
      ASSERT_LE(std::abs(sample.displacement - before), steepest * kStep + 1e-15)
          << p.x << " " << p.y;
      before = sample.displacement;
      if (sample.displacement == 0) continue;
      const double rise = (field.SampleAt(p + kSmall * way).displacement -
                           field.SampleAt(p - kSmall * way).displacement) /
                          (2 * kSmall);
      ++count;
      // curvature up to 1e5 /m over 1 nm, and cancellation of 1e-19 m over it
      if (std::abs(rise - glm::dot(sample.gradient, way)) > 2e-4) ++wrong;
    }
  }
  EXPECT_GE(count, felt);
  EXPECT_LT(wrong, count / 1000);  // points within 1 nm of a crease
}

}  // namespace moontrace
