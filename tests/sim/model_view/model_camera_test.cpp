#include "sim/model_view/model_camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/model_view/visibility.h"
#include "sim/physics/felt_object.h"
#include "tests/sim/model_view_fixture.h"
#include "tests/sim/scene_fixture.h"

namespace moontrace {
namespace {

constexpr double kAspect = 16.0 / 9;

class ModelCameraTest : public testing::Test {
 protected:
  void SetUp() override {
    labelled_ = LabelledFrom(CanXml());
    d_ = MakeData(*labelled_.model->m, "test");
    mj_forward(labelled_.model->m.get(), d_.get());
    mjv_defaultScene(&scene_);
    mjv_makeScene(labelled_.model->m.get(), &scene_, 100);
  }
  void TearDown() override { mjv_freeScene(&scene_); }

  mjvCamera On(const char* name) {
    return CameraOn(*labelled_.model, *d_, FindTarget(*labelled_.model, name),
                    WholeModel(*labelled_.model->m), {0.01, 0.02, 0.03}, kAspect);
  }
  Sight Through(mjvCamera camera) {
    mjvOption option;
    mjv_defaultOption(&option);
    mjv_updateScene(labelled_.model->m.get(), d_.get(), &option, nullptr, &camera, mjCAT_ALL,
                    &scene_);
    return {scene_, kAspect};
  }

  LabelledModel labelled_;
  DataPtr d_;
  mjvScene scene_;
};

TEST_F(ModelCameraTest, ALabelIsSeenFromTheSideThatItIsReadFrom) {
  for (const ViewModel::Label& label : labelled_.model->labels) {
    const Sight sight = Through(On(label.name.c_str()));
    const Pose X_WG = PoseOfGeom(*d_, label.geom);
    for (const glm::dvec2 p_P : {label.text_P.min, label.text_P.max}) {
      const glm::dvec3 p_O = label.chart.ToObject({p_P, 0});
      const glm::dvec3 p_W = ToWorld(X_WG, p_O);
      EXPECT_GT(glm::dot(TurnToWorld(X_WG, label.chart.Above(p_O).normal_O), sight.ToEye(p_W)), 0)
          << label.name;
      const auto share = sight.ShareOf(p_W);
      ASSERT_TRUE(share) << label.name;
      EXPECT_GT(std::min(share->x, share->y), 0) << label.name;
      EXPECT_LT(std::max(share->x, share->y), 1) << label.name;
    }
    // its lines run to the right and up
    const auto begin = sight.ShareOf(ToWorld(X_WG, label.chart.ToObject({label.text_P.min, 0})));
    const auto end = sight.ShareOf(ToWorld(X_WG, label.chart.ToObject({label.text_P.max, 0})));
    EXPECT_LT(begin->x, end->x) << label.name;
    EXPECT_LT(begin->y, end->y) << label.name;
  }
}

// A wall of 12 by 12 cm stands 6 cm before the can: straight on it hides the label.
TEST_F(ModelCameraTest, ALabelBehindSomethingIsLookedAtFromBesideIt) {
  const ViewModel::Label& can = labelled_.model->labels.front();
  const auto shares = [&] {
    return SharesSeen(*labelled_.model, *d_, can, Through(On("can")).eye_W);
  };
  EXPECT_EQ(shares().hidden, 0);
  d_->qpos[kInserted + 1] = -0.3;
  mj_forward(labelled_.model->m.get(), d_.get());
  EXPECT_GT(SharesSeen(*labelled_.model, *d_, can, {0, -0.5, 0.05}).hidden, 0.5);
  EXPECT_LT(shares().hidden, 0.1);
  EXPECT_GT(shares().seen, 0.5);
}

TEST_F(ModelCameraTest, AGeomFillsThePictureAndAllOfItIsSeen) {
  const Sight sight = Through(On("wall"));
  for (const double x : {-0.06, 0.06}) {
    for (const double z : {-0.06, 0.06}) {
      const auto share = sight.ShareOf(glm::dvec3(0.3 + x, -0.1, 0.05 + z));
      ASSERT_TRUE(share);
      EXPECT_TRUE(share->x > 0 && share->x < 1 && share->y > 0 && share->y < 1);
      EXPECT_GT(std::abs(share->y - 0.5), 0.2);
    }
  }
}

TEST_F(ModelCameraTest, TheModelsOwnCameraIsTakenAndCanBeMovedThen) {
  const mjvCamera camera = On("reader");
  EXPECT_EQ(camera.type, mjCAMERA_FIXED);
  const Sight sight = Through(camera);
  const mjvCamera free = Freed(camera, sight, 0.3);
  EXPECT_EQ(free.type, mjCAMERA_FREE);
  const Sight same = Through(free);
  EXPECT_LT(glm::distance(same.eye_W, sight.eye_W), 1e-6);
  EXPECT_GT(glm::dot(same.forward_W, sight.forward_W), 1 - 1e-9);
}

TEST_F(ModelCameraTest, ZoomKeepsWhatIsUnderTheMouseAndDragTakesItAlong) {
  mjvCamera camera = On("can");
  const Sight before = Through(camera);
  const glm::dvec2 mouse(0.6, 0.55);
  const Sight::Ray ray = before.RayUnder(mouse);
  const double depth = before.DepthOf(LookedAt(camera));
  const glm::dvec3 p_W = ray.from_W + depth / glm::dot(ray.along_W, before.forward_W) * ray.along_W;
  Zoom(camera, before, mouse, 0.5);
  const auto zoomed = Through(camera).ShareOf(p_W);
  EXPECT_NEAR(zoomed->x, mouse.x, 1e-4);
  EXPECT_NEAR(zoomed->y, mouse.y, 1e-4);
  Shift(camera, Through(camera), {0.1 * kAspect, -0.2});
  const auto shifted = Through(camera).ShareOf(p_W);
  EXPECT_NEAR(shifted->x, mouse.x + 0.1, 1e-4);
  EXPECT_NEAR(shifted->y, mouse.y - 0.2, 1e-4);
}

TEST_F(ModelCameraTest, TurningStaysUpright) {
  mjvCamera camera = On("can");
  Turn(camera, {0.25, 5});
  EXPECT_EQ(camera.elevation, 89);
  EXPECT_NEAR(camera.azimuth, On("can").azimuth - 45, 1e-9);
}

}  // namespace
}  // namespace moontrace
