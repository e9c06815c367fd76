#include "sim/model_view/sight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "sim/model_view/model_camera.h"
#include "sim/physics/mujoco_compat.h"
#include "tests/sim/model_view_fixture.h"

namespace moontrace {
namespace {

constexpr double kAspect = 1.5;

/// A camera at (0, -1, 0) that looks along y, 90 degrees from lower to upper edge.
class SightTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string warning;
    m_ = CompileMjcf(
        "<mujoco><worldbody><camera name='eye' pos='0 -1 0' xyaxes='1 0 0 0 0 1' "
        "fovy='90'/><geom size='.1'/></worldbody></mujoco>",
        "sight.xml", "sight", warning);
    d_ = MakeData(*m_, "sight");
    mj_forward(m_.get(), d_.get());
    mjv_defaultScene(&scene_);
    mjv_makeScene(m_.get(), &scene_, 10);
    mjvOption option;
    mjv_defaultOption(&option);
    mjvCamera camera;
    mjv_defaultCamera(&camera);
    camera.type = mjCAMERA_FIXED;
    camera.fixedcamid = 0;
    mjv_updateScene(m_.get(), d_.get(), &option, nullptr, &camera, mjCAT_ALL, &scene_);
    sight_ = Sight(scene_, kAspect);
  }
  void TearDown() override { mjv_freeScene(&scene_); }

  ModelPtr m_;
  DataPtr d_;
  mjvScene scene_;
  Sight sight_;
};

TEST_F(SightTest, PointsAreSeenWherePerspectiveHasThem) {
  const auto middle = sight_.ShareOf({0, 1, 0});
  ASSERT_TRUE(middle);
  EXPECT_NEAR(middle->x, 0.5, 1e-6);
  EXPECT_NEAR(middle->y, 0.5, 1e-6);
  // 45 degrees up is the upper edge, and so far to the right, by the picture's shape, 5/6
  const auto edge = sight_.ShareOf({1, 0, 1});
  ASSERT_TRUE(edge);
  EXPECT_NEAR(edge->y, 1, 1e-6);
  EXPECT_NEAR(edge->x, 0.5 + 0.5 / kAspect, 1e-6);
  EXPECT_FALSE(sight_.ShareOf({0, -2, 0}));
  EXPECT_NEAR(sight_.HeightAt({0, 1, 0}), 4, 1e-6);
}

TEST_F(SightTest, ARayLeadsBackToThePoint) {
  const glm::dvec3 p_W(0.3, 0.7, -0.4);
  const Sight::Ray ray = sight_.RayUnder(*sight_.ShareOf(p_W));
  EXPECT_LT(glm::length(glm::cross(p_W - ray.from_W, ray.along_W)), 1e-6);
}

TEST_F(SightTest, DepthGrowsFromNearToFarOrBackwards) {
  const auto depth = [this](double y, bool reversed) {
    const glm::dvec4 clip = sight_.ClipOf({0, y, 0}, reversed);
    return clip.z / clip.w;
  };
  const mjvGLCamera& camera = scene_.camera[0];
  EXPECT_NEAR(depth(-1 + camera.frustum_near, false), -1, 1e-4);
  EXPECT_NEAR(depth(-1 + camera.frustum_far, false), 1, 1e-4);
  EXPECT_NEAR(depth(-1 + camera.frustum_near, true), 1, 1e-4);
  EXPECT_NEAR(depth(-1 + camera.frustum_far, true), -1, 1e-4);
}

}  // namespace
}  // namespace moontrace
