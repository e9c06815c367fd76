#include "sim/physics/mesh_label.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "sim/physics/felt_object.h"
#include "sim/physics/model_loader.h"
#include "tests/sim/scene_fixture.h"

namespace moontrace {
namespace {

const char kPlate[] =
    "-.1 -.06 -.004 .1 -.06 -.004 -.1 .06 -.004 .1 .06 -.004 "
    "-.1 -.06 .004 .1 -.06 .004 -.1 .06 .004 .1 .06 .004";

/// A prism of 32 sides around z, which MuJoCo takes for the hull of its corners.
std::string Can() {
  std::string corners;
  for (int i = 0; i < 32; ++i) {
    const double a = 2 * std::numbers::pi * i / 32;
    for (const double z : {-0.05, 0.05}) {
      corners += std::to_string(0.04 * std::cos(a)) + " " + std::to_string(0.04 * std::sin(a)) +
                 " " + std::to_string(z) + " ";
    }
  }
  return corners;
}

/// A body of one mesh with labels, `body` in its tag.
std::string Model(const std::string& corners, const std::vector<std::string>& labels,
                  const std::string& body = "<body name='b' pos='0 0 0.3'>") {
  std::string texts;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    texts +=
        "<text name='moontrace:thing:" + std::to_string(i) + "' data=\"{" + labels[i] + "}\"/>";
  }
  return "<mujoco><option timestep='0.001'/><asset><mesh name='m' vertex='" + corners +
         "'/></asset><custom>" + texts + "</custom><worldbody>" + body +
         "<geom name='thing' type='mesh' mesh='m' mass='0.3'/></body></worldbody></mujoco>";
}

LoadedModel Load(const std::string& xml) { return LoadModel(xml, "", "m.xml", 0); }
std::string Refusal(const std::string& xml) {
  return ErrorOf([&] { Load(xml); });
}

TEST(MeshLabel, LiesOnWhatWasFittedAndSaysSo) {
  const LoadedModel loaded = Load(Model(Can(), {"text='TEA', face='front', middle_mm=[0,10]"}));
  const Label& label = loaded.labels.front();
  const int carrier = label.carrier;
  EXPECT_EQ(loaded.m->geom_type[carrier], mjGEOM_CYLINDER);
  EXPECT_NEAR(loaded.m->geom_size[3 * carrier], 0.04, 2e-6);
  EXPECT_EQ(label.face, Face::kRound);
  EXPECT_NEAR(label.middle->y, 0.01, 2e-6);
  EXPECT_EQ(NameOf(label), "thing");
  const auto said = [&](const std::string& remark) {
    return Holds(remark, "cylinder of 40 mm radius and 100 mm length") && IsOneLine(remark);
  };
  EXPECT_TRUE(std::any_of(loaded.remarks.begin(), loaded.remarks.end(), said));
}

// Each of two solids in one place would push the tip out of the other's grooves.
TEST(MeshLabel, PartsOfOneSolidShareIt) {
  const LoadedModel plate = Load(Model(kPlate, {"text='A'", "text='B', face='bottom'"}));
  EXPECT_EQ(plate.labels[0].carrier, plate.labels[1].carrier);
  EXPECT_NE(plate.labels[0].face, plate.labels[1].face);
  const LoadedModel can = Load(Model(Can(), {"text='A'", "text='B', face='front'"}));
  EXPECT_EQ(can.labels[0].carrier, can.labels[1].carrier);
  EXPECT_EQ(can.labels[0].face, Face::kTop);
  EXPECT_EQ(can.labels[1].face, Face::kRound);
}

TEST(MeshLabel, ARecordsModelIsTakenAsItIs) {
  const std::string xml = Model(kPlate, {"text='A'", "text='B', face='bottom'"});
  const Scene scene = Scene::FromXml(xml, "m.xml", {});
  const Scene again = Scene::FromXml(scene.model_xml(), "m.xml", {});
  EXPECT_EQ(again.model()->ngeom, scene.model()->ngeom);
  EXPECT_EQ(again.model_xml(), scene.model_xml());
}

TEST(MeshLabel, TheBodyMovesAsWithoutItToTheBit) {
  const std::string xml = Model(Can(), {"text='TEA', face='front'", "text='TOP'"},
                                "<body name='b' pos='0 0 0.3'><freejoint/>");
  Scene scene = Scene::FromXml(xml, "m.xml", {});
  std::string warning;
  const ModelPtr m = CompileMjcf(xml, "theirs.xml", "theirs", warning);
  const DataPtr d = MakeData(*m, "theirs");
  d->qvel[3] = scene.data()->qvel[kInserted + 3] = 2;
  d->qvel[4] = scene.data()->qvel[kInserted + 4] = -1;
  for (int i = 0; i < 300; ++i) {
    mj_step(m.get(), d.get());
    scene.Tick(TipAt({0.5, 0.5, 0.5}));
    ASSERT_TRUE(std::equal(d->qpos, d->qpos + m->nq, scene.data()->qpos + kInserted)) << i;
  }
}

TEST(MeshLabel, AHeightFieldCarriesOnItsFlatPart) {
  // flat all over, as MuJoCo makes a field without a file
  const LoadedModel loaded = Load(
      "<mujoco><asset><hfield name='h' nrow='20' ncol='30' size='.1 .08 .02 .01'/></asset><custom>"
      "<text name='moontrace:land' data=\"{text='SEA'}\"/></custom><worldbody>"
      "<geom name='land' type='hfield' hfield='h' quat='1 0 1 0'/></worldbody></mujoco>");
  const int carrier = loaded.labels.front().carrier;
  EXPECT_NEAR(loaded.m->geom_size[3 * carrier], 0.1, 1e-6);
  EXPECT_NEAR(loaded.m->geom_size[3 * carrier + 1], 0.08, 1e-6);
}

TEST(MeshLabel, RefusesInOneLine) {
  const std::string large = Refusal(
      "<mujoco><asset><hfield name='h' nrow='600' ncol='600' size='1 1 1 1'/></asset><custom>"
      "<text name='moontrace:land' data=\"{text='SEA'}\"/></custom><worldbody>"
      "<geom name='land' type='hfield' hfield='h'/></worldbody></mujoco>");
  EXPECT_TRUE(IsOneLine(large) && Holds(large, "make it coarser")) << large;
  const std::string at = Refusal(Model(kPlate, {"text='A', at_mm=[0,0]"}));
  EXPECT_TRUE(IsOneLine(at) && Holds(at, "give middle_mm")) << at;
  const std::string face = Refusal(Model(kPlate, {"text='A', face='round'"}));
  EXPECT_TRUE(IsOneLine(face) && Holds(face, "take top, bottom, front")) << face;
  const std::string beside = Refusal(Model(kPlate, {"text='A', middle_mm=[300,0]"}));
  EXPECT_TRUE(IsOneLine(beside) && Holds(beside, "nothing of the geom is met")) << beside;
  // a corner of a cube, met in the middle of its bounds, which lies on an edge
  const std::string edge =
      Refusal(Model("0 0 0 .1 0 0 0 .1 0 0 0 .1", {"text='A', face='bottom'"}));
  EXPECT_TRUE(IsOneLine(edge) && Holds(edge, "at its edge: choose another face")) << edge;
  const std::string thin = Refusal(Model(kPlate, {"text='A', face='front', middle_mm=[0,0]"}));
  EXPECT_EQ(thin, "");  // 8 mm high: room for small letters, checked when they are set
}

}  // namespace
}  // namespace moontrace
