#include "sim/page_view/page_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace moontrace {
namespace {

TEST(PageCamera, FromAboveSeesARectangleOfItsHeight) {
  const PageCamera camera{{0.05, 0.02}, 0.1, 0};
  const Box box = VisibleBox(camera, 1.5);
  EXPECT_NEAR(box.min.x, 0.05 - 0.075, 1e-12);
  EXPECT_NEAR(box.max.x, 0.05 + 0.075, 1e-12);
  EXPECT_NEAR(box.min.y, -0.03, 1e-12);
  EXPECT_NEAR(box.max.y, 0.07, 1e-12);
}

// In the middle column: the eye leans back by a; a ray b above the middle meets the plane where the
// law of sines puts it: y = d sin b / cos(a + b), d the distance.
TEST(PageCamera, LeaningSeesFartherAboveThanBelow) {
  const double a = 0.5, b = kFieldOfView / 2;
  const PageCamera camera{{0, 0}, 0.1, a};
  const double d = EyeDistance(camera);
  EXPECT_NEAR(d, 0.05 / std::tan(b), 1e-12);
  EXPECT_NEAR(PointUnder(camera, 1, {0.5, 1}).y, d * std::sin(b) / std::cos(a + b), 1e-12);
  EXPECT_NEAR(PointUnder(camera, 1, {0.5, 0}).y, -d * std::sin(b) / std::cos(a - b), 1e-12);
  EXPECT_NEAR(PointUnder(camera, 1, {0.5, 0.5}).y, 0, 1e-12);
}

TEST(PageCamera, BeyondTheHorizonIsBounded) {
  const PageCamera camera{{0, 0}, 0.1, 1.4};
  const Box box = VisibleBox(camera, 2);
  EXPECT_LE(box.max.y, 0.8 + 1e-12);
  EXPECT_LE(box.max.x, 0.8 + 1e-12);
}

TEST(PageCamera, ZoomKeepsThePointUnderTheMouse) {
  const PageCamera camera{{0.05, 0.02}, 0.1, 0.3};
  const glm::dvec2 share(0.8, 0.25);
  const PageCamera zoomed = Zoomed(camera, 1.6, share, 0.5);
  EXPECT_NEAR(zoomed.height, 0.05, 1e-12);
  EXPECT_LT(glm::distance(PointUnder(camera, 1.6, share), PointUnder(zoomed, 1.6, share)), 1e-12);
  EXPECT_EQ(Zoomed(camera, 1.6, share, 1e-9).height, 0.002);
  EXPECT_EQ(Zoomed(camera, 1.6, share, 1e9).height, 2);
}

TEST(PageCamera, WhatIsSeenAtAPointLiesUnderIt) {
  for (const double lean : {0.0, 0.6}) {
    const PageCamera camera{{0.05, 0.02}, 0.1, lean};
    for (const glm::dvec2 share : {glm::dvec2(0.5, 0.5), glm::dvec2(0.1, 0.9)}) {
      const auto seen = ShareOf(camera, 1.6, PointUnder(camera, 1.6, share));
      ASSERT_TRUE(seen);
      EXPECT_LT(glm::distance(*seen, share), 1e-12);
    }
  }
  EXPECT_FALSE(ShareOf({{0, 0}, 0.1, 1.2}, 1, {0, -10}));  // behind the eye
}

// Straight from above, what lies higher by a tenth of the eye's distance is seen larger by 1 / 0.9.
TEST(PageCamera, SeesWhatIsLiftedNearer) {
  PageCamera camera;
  camera.height = 0.1;
  const glm::dvec3 lifted(0.02, 0.03, 0.1 * EyeDistance(camera));
  const auto seen = ShareOf(camera, 1, lifted);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->x - 0.5, 0.2 / 0.9, 1e-12);
  EXPECT_NEAR(seen->y - 0.5, 0.3 / 0.9, 1e-12);
}

TEST(PageCamera, ShowsAWholeBox) {
  for (const double aspect : {0.5, 1.0, 3.0}) {
    const Box box{{0.01, 0.02}, {0.15, 0.06}};
    const Box seen = VisibleBox(CameraOn(box, aspect), aspect);
    EXPECT_LE(seen.min.x, box.min.x + 1e-12);
    EXPECT_GE(seen.max.x, box.max.x - 1e-12);
    EXPECT_LE(seen.min.y, box.min.y + 1e-12);
    EXPECT_GE(seen.max.y, box.max.y - 1e-12);
  }
}

}  // namespace
}  // namespace moontrace
