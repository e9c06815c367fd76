#include "sim/model_view/label_relief.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "sim/physics/felt_object.h"
#include "tests/sim/model_view_fixture.h"

namespace moontrace {
namespace {

class LabelReliefTest : public testing::Test {
 protected:
  LabelledModel labelled_ = LabelledFrom(CanXml());
  const ViewModel::Label& label_ = labelled_.model->labels[0];
  ReliefArea area_{Grown(label_.text_P, 1e-3), 0.2e-3};
  LabelRelief relief_ = MakeRelief(label_.chart, *labelled_.page, area_);
};

// The normal of r(u, v) = chart(u, v, h(u, v)) by differences of points of the engraved surface.
TEST_F(LabelReliefTest, NormalsAreThoseOfTheEngravedSurface) {
  const auto surface = [&](glm::dvec2 p_P) {
    return label_.chart.ToObject({p_P, labelled_.page->SampleAt(p_P).displacement});
  };
  std::size_t slopes = 0;
  for (const ReliefPoint& point : relief_.points) {
    const glm::dvec2 p_P = label_.chart.At(glm::dvec3(point.p_O)).p_P;
    constexpr double kStep = 2e-6;
    const glm::dvec2 x(kStep, 0), y(0, kStep);
    const glm::dvec3 right = surface(p_P + x) - surface(p_P),
                     left = surface(p_P) - surface(p_P - x);
    const glm::dvec3 up = surface(p_P + y) - surface(p_P), down = surface(p_P) - surface(p_P - y);
    const bool crease =
        glm::distance(right, left) > 0.05 * kStep || glm::distance(up, down) > 0.05 * kStep;
    if (crease) continue;
    const glm::dvec3 normal = glm::normalize(glm::cross(right + left, up + down));
    // h is in the chart's units, the surface is sunk: their slopes differ by h over the radius
    EXPECT_GT(glm::dot(normal, glm::dvec3(point.relief_O)), 0.999);
    if (glm::dot(point.smooth_O, point.relief_O) < 0.9F) ++slopes;
  }
  EXPECT_GT(slopes, 100U);
}

TEST_F(LabelReliefTest, OnlyWhatIsNotFlatIsLaid) {
  EXPECT_GT(relief_.triangles.size(), 3000U);
  const double cells = (area_.box_P.max.x - area_.box_P.min.x) *
                       (area_.box_P.max.y - area_.box_P.min.y) / (area_.step * area_.step);
  EXPECT_LT(static_cast<double>(relief_.points.size()), 0.6 * cells);
  const TextureField blank;
  EXPECT_TRUE(MakeRelief(label_.chart, blank, area_).triangles.empty());
}

TEST_F(LabelReliefTest, WhatIsMadeServesUntilTheViewNeedsMore) {
  const ReliefArea part{{area_.box_P.min + 1e-3, area_.box_P.max - 1e-3}, area_.step};
  EXPECT_TRUE(Serves(area_, part));
  EXPECT_FALSE(Serves(part, area_));
  EXPECT_FALSE(Serves(area_, {area_.box_P, 0.5 * area_.step}));
}

TEST(ReliefTint, DarkThingsAreMadeLighter) {
  EXPECT_LT(TintFor(0.8, false).groove.x, 1);
  EXPECT_GT(TintFor(0.05, false).groove.x, 1);
  EXPECT_LT(TintFor(0.8, true).groove.x, TintFor(0.8, false).groove.x);
}

}  // namespace
}  // namespace moontrace
