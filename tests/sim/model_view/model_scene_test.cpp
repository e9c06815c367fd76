#include "sim/model_view/model_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

#include "sim/page_view/gl_headless.h"
#include "sim/physics/felt_object.h"
#include "tests/sim/model_view_fixture.h"
#include "tests/sim/scene_fixture.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

constexpr int kWidth = 320, kHeight = 240;
constexpr double kAspect = static_cast<double>(kWidth) / kHeight;
constexpr int kTurn = 0, kSlide = 1;  // in qpos

class ModelSceneTest : public testing::Test {
 protected:
  void SetUp() override {
    try {
      gl_ = std::make_unique<HeadlessGl>();
    } catch (const LackError& lack) {
      GTEST_SKIP() << lack.what();
    }
    labelled_ = LabelledFrom(CanXml());
    scene_ = std::make_unique<ModelScene>(labelled_.model, kWidth, kHeight);
    scene_->Aim(false);
    LookFrom("reader");
  }

  void LookFrom(const char* name) {
    scene_->camera = CameraOn(*labelled_.model, scene_->data(), FindTarget(*labelled_.model, name),
                              scene_->camera, {0, 0, 0}, kAspect);
  }
  void Move(int joint, double to) {
    ScenePose pose = labelled_.model->start;
    pose.qpos[static_cast<std::size_t>(kInserted + joint)] = to;
    scene_->SetPose(pose);
  }
  Raster Drawn(bool labelled) {
    scene_->SetPage(labelled ? labelled_.page : nullptr, labelled_.model->labels[0].text_P);
    scene_->Draw({}, 0, 0, kWidth, kHeight);
    return scene_->Picture();
  }

  /// Points of the picture that the page's label changes, from the lower left, 0 to 1.
  std::vector<glm::dvec2> Changed() {
    const Raster plain = Drawn(false), labelled = Drawn(true);
    std::vector<glm::dvec2> changed;
    for (std::size_t row = 0; row < plain.height; ++row) {
      for (std::size_t column = 0; column < plain.width; ++column) {
        const std::size_t at = 3 * (row * plain.width + column);
        bool same = true;
        for (std::size_t i = 0; i < 3; ++i) same &= plain.rgb[at + i] == labelled.rgb[at + i];
        if (same) continue;
        changed.emplace_back((static_cast<double>(column) + 0.5) / kWidth,
                             1 - (static_cast<double>(row) + 0.5) / kHeight);
      }
    }
    return changed;
  }

  /// How many of them show the label's own geom where the text lies, to half a millimetre.
  std::size_t OnText(const std::vector<glm::dvec2>& changed) {
    const ViewModel::Label& label = labelled_.model->labels[0];
    const Sight sight = scene_->Look(kAspect);
    const Pose X_WG = PoseOfGeom(scene_->data(), label.geom);
    std::size_t count = 0;
    for (const glm::dvec2 share : changed) {
      const Sight::Ray ray = sight.RayUnder(share);
      const double from[3] = {ray.from_W.x, ray.from_W.y, ray.from_W.z};
      const double along[3] = {ray.along_W.x, ray.along_W.y, ray.along_W.z};
      const double far =
          DistanceOnRay(*labelled_.model->m, scene_->data(), label.geom, from, along);
      if (far < 0) continue;
      const glm::dvec3 p_O = FromWorld(X_WG, ray.from_W + far * ray.along_W);
      if (Contains(Grown(label.text_P, 0.0006), label.chart.At(p_O).p_P)) ++count;
    }
    return count;
  }

  std::unique_ptr<HeadlessGl> gl_;
  LabelledModel labelled_;
  std::unique_ptr<ModelScene> scene_;  // freed before its context
};

TEST_F(ModelSceneTest, ALabelChangesThePictureOnlyWhereItLies) {
  const std::vector<glm::dvec2> changed = Changed();
  EXPECT_GT(changed.size(), 150U);
  EXPECT_EQ(OnText(changed), changed.size());
}

TEST_F(ModelSceneTest, ItStaysOnTheGeomThatTurns) {
  const std::vector<glm::dvec2> before = Changed();
  Move(kTurn, 0.6);
  const std::vector<glm::dvec2> turned = Changed();
  EXPECT_GT(turned.size(), 100U);
  EXPECT_EQ(OnText(turned), turned.size());
  EXPECT_NE(turned, before);
  Move(kTurn, 3.14159);
  EXPECT_TRUE(Changed().empty());  // at the back
}

TEST_F(ModelSceneTest, WhatStandsBeforeItHidesIt) {
  Move(kSlide, -0.3);
  EXPECT_TRUE(Changed().empty());
  Move(kSlide, -0.36);  // the right part of it is seen beside the wall
  const std::vector<glm::dvec2> changed = Changed();
  EXPECT_FALSE(changed.empty());
  for (const glm::dvec2 share : changed) EXPECT_GT(share.x, 0.5);
}

TEST_F(ModelSceneTest, LightFallsOnEngravedEdgesAsOnSlopes) {
  LookFrom("can");
  scene_->camera.distance *= 0.6;
  const Raster plain = Drawn(false), labelled = Drawn(true);
  int darker = 0, lighter = 0;
  for (std::size_t i = 0; i < plain.rgb.size(); ++i) {
    if (labelled.rgb[i] + 10 < plain.rgb[i]) ++darker;
    if (labelled.rgb[i] > plain.rgb[i] + 2) ++lighter;
  }
  EXPECT_GT(darker, 500);  // the bottom, and the slope that lies in the shade
  EXPECT_GT(lighter, 50);  // the slope towards the light
}

TEST_F(ModelSceneTest, WithoutLabelsItIsMujocosOwnPicture) {
  std::string xml = CanXml();
  const std::size_t plate = xml.find("<text name=\"moontrace:plate\"");
  xml.erase(plate, xml.find("/>", plate) + 2 - plate);
  labelled_ = LabelledFrom(xml);
  scene_ = std::make_unique<ModelScene>(labelled_.model, kWidth, kHeight);
  LookFrom("reader");
  ModelPtr m(mj_copyModel(nullptr, labelled_.model->m.get()));
  m->vis.global.offwidth = kWidth;
  m->vis.global.offheight = kHeight;
  const DataPtr d = MakeData(*m, "plain");
  mj_forward(m.get(), d.get());
  mjvScene scene;
  mjv_defaultScene(&scene);
  mjv_makeScene(m.get(), &scene, 1000);
  mjvOption option;
  mjv_defaultOption(&option);
  option.geomgroup[1] = 0;  // Moontrace's own
  mjrContext context;
  mjr_defaultContext(&context);
  mjr_makeContext(m.get(), &context, mjFONTSCALE_50);
  mjr_setBuffer(mjFB_OFFSCREEN, &context);
  mjvCamera camera = scene_->camera;
  mjv_updateScene(m.get(), d.get(), &option, nullptr, &camera, mjCAT_ALL, &scene);
  const mjrRect rect = {0, 0, kWidth, kHeight};
  mjr_render(rect, &scene, &context);
  constexpr std::size_t kRow = std::size_t{3} * kWidth;
  std::vector<unsigned char> bottom_up(kRow * kHeight);
  mjr_readPixels(bottom_up.data(), nullptr, rect, &context);
  mjr_freeContext(&context);
  mjv_freeScene(&scene);
  scene_->Aim(false);
  const Raster picture = Drawn(false);
  std::size_t other = 0;
  for (std::size_t row = 0; row < picture.height; ++row) {
    for (std::size_t i = 0; i < 3 * picture.width; ++i) {
      const unsigned char plain = bottom_up[kRow * (kHeight - 1 - row) + i];
      if (plain != picture.rgb[kRow * row + i]) ++other;
    }
  }
  EXPECT_EQ(other, 0U);
}

}  // namespace
}  // namespace moontrace
