#include "sim/model_view/model_words.h"

#include <gtest/gtest.h>

#include "sim/model_view/model_camera.h"
#include "tests/sim/model_view_fixture.h"
#include "tests/sim/scene_fixture.h"

namespace moontrace {
namespace {

class ModelWordsTest : public testing::Test {
 protected:
  void SetUp() override {
    d_ = MakeData(*labelled_.model->m, "test");
    mj_forward(labelled_.model->m.get(), d_.get());
    mjv_defaultScene(&scene_);
    mjv_makeScene(labelled_.model->m.get(), &scene_, 100);
  }
  void TearDown() override { mjv_freeScene(&scene_); }

  std::vector<std::string> Words(const char* name, const std::optional<SeenTip>& tip = {}) {
    const ViewTarget target = FindTarget(*labelled_.model, name);
    mjvCamera camera =
        CameraOn(*labelled_.model, *d_, target, WholeModel(*labelled_.model->m), {0, 0, 0}, 1.5);
    mjvOption option;
    mjv_defaultOption(&option);
    mjv_updateScene(labelled_.model->m.get(), d_.get(), &option, nullptr, &camera, mjCAT_ALL,
                    &scene_);
    return WordsOfView(*labelled_.model, *d_, Sight(scene_, 1.5), target, tip);
  }

  LabelledModel labelled_ = LabelledFrom(CanXml());
  DataPtr d_;
  mjvScene scene_;
};

TEST_F(ModelWordsTest, TellWhereEachLabelIsSeenOrWhyNot) {
  EXPECT_EQ(Words("reader"),
            (std::vector<std::string>{"Seen by the camera reader, from the front.",
                                      "moon on can, a cylinder: all of it is seen, in the middle.",
                                      "Not seen: sea on plate, a box: turned away."}));
  d_->qpos[kInserted] = 3.14159;
  mj_forward(labelled_.model->m.get(), d_.get());
  EXPECT_EQ(Words("reader")[1], "Not seen: moon on can, a cylinder: turned away.");
  d_->qpos[kInserted] = 0;
  d_->qpos[kInserted + 1] = -0.3;
  mj_forward(labelled_.model->m.get(), d_.get());
  EXPECT_EQ(Words("reader")[1], "Not seen: moon on can, a cylinder: hidden behind wall, a box.");
}

// The reader sees 0.124 m to either side of its middle where the wall slides, 0.2 m away: of the
// wall, 0.12 m wide, a strip is seen where its middle is not.
TEST_F(ModelWordsTest, TellWhatReachesIntoThePictureFromBesideIt) {
  const auto with_wall_at = [&](double x) {
    d_->qpos[kInserted + 1] = x - 0.3;
    mj_forward(labelled_.model->m.get(), d_.get());
    return Words("reader").back();
  };
  EXPECT_EQ(with_wall_at(0.17), "Beside: wall, a box.");
  EXPECT_EQ(with_wall_at(0.20), "Not seen: sea on plate, a box: turned away.");
}

TEST_F(ModelWordsTest, TellWhereTheTipIs) {
  EXPECT_EQ(Words("reader", SeenTip{{0, -0.04, 0.05}, 0, true}).back(),
            "The tip touches can, a cylinder, in the middle.");
  EXPECT_EQ(Words("reader", SeenTip{{0.1, -0.05, 0.05}, 0.012, false}).back(),
            "The tip is in the air, 12 mm from can, a cylinder, at the right.");
}

}  // namespace
}  // namespace moontrace
