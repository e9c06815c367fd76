#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>

#include "sim/physics/mujoco_compat.h"
#include "sim/physics/scene.h"
#include "tests/sim/scene_fixture.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

/// A model of MuJoCo's own samples, the geom that carries a label, and how long it is watched.
struct Sample {
  const char* file;
  const char* geom;
  int steps;
  const char* face = "";
};
void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.file; }

constexpr Sample kSamples[] = {
    {"adhesion/active_adhesion.xml", "two crates/1", 2000},
    {"composite/cloth.xml", "world/1", 300},
    {"composite/grid2pin.xml", "world/1", 1000},
    {"composite/loop.xml", "world/1", 1000},
    {"composite/particle.xml", "+x", 500},
    {"composite/rope.xml", "world/1", 1000},
    {"composite/softbox.xml", "world/1", 300},
    {"flag/flag.xml", "floor", 500},
    {"hammock/hammock.xml", "torso/1", 500},
    {"humanoid/22_humanoids.xml", "1a_torso", 300},
    {"humanoid/humanoid.xml", "torso/1", 2000},
    {"humanoid100/humanoid100.xml", "torso/1", 300},
    {"mug/mug.xml", "mug/1", 2000, ", face='front'"},
    {"slider_crank/slider_crank.xml", "world/1", 2000},
    {"tendon_arm/arm26.xml", "forearm", 2000},
};

/// Where Debian's package libmujoco-samples puts them, or MOONTRACE_MUJOCO_MODELS.
fs::path Folder() {
  const char* named = std::getenv("MOONTRACE_MUJOCO_MODELS");
  return named != nullptr ? named : "/usr/share/mujoco/model";
}

/// The sample with a line for the label, in a copy of its folder.
fs::path Labelled(const Sample& sample) {
  const fs::path from = Folder() / sample.file;
  const fs::path copy = fs::path(testing::TempDir()) / "models_of_others";
  fs::remove_all(copy);
  fs::copy(from.parent_path(), copy, fs::copy_options::recursive);
  std::ifstream file(from);
  std::string xml{std::istreambuf_iterator<char>(file), {}};
  const std::string line = std::string("<custom><text name=\"moontrace:") + sample.geom +
                           "\" data=\"{text='O', size_mm=4" + sample.face + "}\"/></custom>";
  xml.insert(xml.rfind("</mujoco>"), line);
  const fs::path labelled = copy / "labelled.xml";
  std::ofstream(labelled) << xml;
  return labelled;
}

class SlowModelsOfOthers : public testing::TestWithParam<Sample> {
 protected:
  void SetUp() override {
    if (!fs::exists(Folder() / GetParam().file)) {
      GTEST_SKIP() << "install libmujoco-samples, or name its folder by MOONTRACE_MUJOCO_MODELS";
    }
  }
};

// In MuJoCo alone the file is stepped as it came.
TEST_P(SlowModelsOfOthers, MoveWithoutTouchAsByThemselves) {
  char error[1000] = "";
  const ModelPtr m(mj_loadXML((Folder() / GetParam().file).c_str(), nullptr, error, sizeof error));
  ASSERT_TRUE(m) << error;
  m->opt.timestep = 0.001;
  const DataPtr d = MakeData(*m, "theirs");
  Scene scene = Scene::Load(Labelled(GetParam()).string(), {});
  const auto before_q = scene.model()->nq - m->nq, before_v = scene.model()->nv - m->nv;
  const bool first = m->nv > 0;
  const glm::dvec3 far_away(0.3, 50, 30);
  for (int i = 0; i < GetParam().steps; ++i) {
    for (int k = 0; k < m->nu; ++k) {
      d->ctrl[k] = scene.data()->ctrl[k] = 0.3 * std::sin(0.01 * i + k);
    }
    mj_step(m.get(), d.get());
    const TickResult felt =
        scene.Tick(TipAt(far_away + glm::dvec3(0, 0.01 * std::sin(0.02 * i), 0)));
    ASSERT_FALSE(felt.fault) << i;
    const mjData& other = *scene.data();
    ASSERT_TRUE(!first || std::equal(d->qpos, d->qpos + m->nq, other.qpos + before_q)) << i;
    ASSERT_TRUE(!first || std::equal(d->qvel, d->qvel + m->nv, other.qvel + before_v)) << i;
    ASSERT_TRUE(std::equal(d->act, d->act + m->na, other.act)) << i;
    ASSERT_TRUE(std::equal(d->sensordata, d->sensordata + m->nsensordata, other.sensordata)) << i;
  }
}

// A tip that goes down with the label, wherever that goes, is pressed back.
TEST_P(SlowModelsOfOthers, AreFelt) {
  const TextureField field = GrooveAlongY();
  Scene scene = Scene::Load(Labelled(GetParam()).string(), {});
  scene.SetField(&field);
  const glm::dvec2 at = scene.laid(0).chart.place().on_page + glm::dvec2(0.002, 0.002);
  double most = 0;
  for (int i = 0; i < 300; ++i) {
    const double height = 0.002 - 1e-5 * i;  // to 1 mm below, at 10 mm/s
    const TickResult felt = scene.Tick(TipAt(scene.PointOn({at, height}).p_W));
    ASSERT_FALSE(felt.fault) << i;
    most = std::max(most, glm::length(felt.force_W));
  }
  EXPECT_GT(most, 0.2);
  EXPECT_LT(most, scene.force_bound());  // of what rests
}

INSTANTIATE_TEST_SUITE_P(Samples, SlowModelsOfOthers, testing::ValuesIn(kSamples),
                         [](const auto& sample) {
                           std::string name = fs::path(sample.param.file).stem().string();
                           name.erase(std::remove(name.begin(), name.end(), '_'), name.end());
                           return name;
                         });

}  // namespace
}  // namespace moontrace
