#include "sim/physics/model_loader.h"

#include <filesystem>
#include <fstream>
#include <glm/vec3.hpp>

#include "tests/sim/scene_fixture.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

/// A folder of its own, the current one meanwhile, so that stray files are seen.
class ModelLoader : public testing::Test {
 protected:
  void SetUp() override {
    home_ = fs::current_path();
    folder_ = fs::temp_directory_path() /
              ("moontrace-loader-" +
               std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "parts");
    fs::create_directories(folder_ / "elsewhere");
    fs::current_path(folder_ / "elsewhere");
  }
  void TearDown() override {
    EXPECT_FALSE(fs::exists(folder_ / "elsewhere" / "MUJOCO_LOG.TXT"));
    fs::current_path(home_);
    fs::remove_all(folder_);
  }
  std::string Write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  static std::string LoadError(const std::string& xml) {
    return ErrorOf([&] { LoadModel(xml, "", "m.xml", 0); });
  }
  static LoadedModel LoadText(const std::string& xml) { return LoadModel(xml, "", "m.xml", 0); }

  fs::path home_;
  fs::path folder_;
};

bool HasRemark(const std::vector<std::string>& remarks, const std::string& part) {
  for (const std::string& remark : remarks) {
    if (Holds(remark, part)) return IsOneLine(remark);
  }
  return false;
}

const char kOwnProxy[] =
    "<body name='moontrace_proxy' pos='0 0 0.1'>"
    "<joint type='slide' axis='1 0 0'/><joint type='slide' axis='0 1 0'/>"
    "<joint type='slide' axis='0 0 1' ref='0.1'/>"
    "<geom size='0.002' mass='0.08' contype='0' conaffinity='0'/></body>";

TEST_F(ModelLoader, InsertsAProxyOfFiftyGrams) {
  const LoadedModel loaded = LoadText(ModelWith("", ""));
  EXPECT_EQ(loaded.proxy.mass, 0.05);
  EXPECT_GE(loaded.proxy.handle_mocap, 0);
  EXPECT_TRUE(HasRemark(loaded.remarks, "proxy.xml was inserted"));
}

TEST_F(ModelLoader, TheModelsDefaultsDoNotReachTheProxy) {
  const LoadedModel loaded = LoadText(
      ModelWith("<compiler inertiafromgeom='true'/><default><joint type='hinge' damping='3' "
                "armature='1' stiffness='5'/><geom density='9000' contype='1'/></default>",
                ""));
  EXPECT_EQ(loaded.proxy.mass, 0.05);
}

TEST_F(ModelLoader, KeepsTheModelsOwnProxy) {
  const LoadedModel loaded = LoadText(ModelWith("", kOwnProxy));
  EXPECT_NEAR(loaded.proxy.mass, 0.08, 1e-15);
  EXPECT_EQ(loaded.proxy.handle_mocap, -1);
  EXPECT_FALSE(HasRemark(loaded.remarks, "inserted"));
  // and finds it, though its slides do not count from zero
  Scene scene = Scene::FromXml(ModelWith("", kOwnProxy), "own", {});
  EXPECT_NEAR(Hold(scene, {0.01, 0.02, -0.001}, 1000).force_W.z, 0.5, 1e-9);
  EXPECT_NEAR(scene.data()->xpos[3 * loaded.proxy.body + 1], 0.02, 1e-12);
}

TEST_F(ModelLoader, RefusesAProxyThatSomethingElseCouldHoldBack) {
  const std::string slides = "<joint type='slide' axis='1 0 0'/><joint type='slide' axis='0 1 0'/>";
  const std::string geom = "<geom size='0.002' mass='0.05' contype='0' conaffinity='0'/>";
  const std::string last = "<joint type='slide' axis='0 0 1'/>";
  const std::string bodies[] = {
      slides + geom,
      "<joint type='hinge' axis='0 0 1'/>" + slides + geom,
      slides + "<joint type='slide' axis='0 1 1'/>" + geom,
      slides + "<joint type='slide' axis='0 0 1' limited='true' range='0 1'/>" + geom,
      slides + "<joint type='slide' axis='0 0 1' damping='1'/>" + geom,
      slides + last + "<geom size='0.002' mass='0.05'/>"};
  for (const std::string& body : bodies) {
    const std::string text =
        LoadError(ModelWith("", "<body name='moontrace_proxy'>" + body + "</body>"));
    EXPECT_TRUE(IsOneLine(text)) << body;
    EXPECT_TRUE(Holds(text, "m.xml: moontrace_proxy")) << text;
  }
}

TEST_F(ModelLoader, RefusesAnythingElseThatPullsOnTheProxy) {
  const std::string more[] = {
      "<equality><weld body1='moontrace_proxy' body2='world'/></equality>",
      "<equality><joint joint1='px' joint2='other'/></equality>",
      "<tendon><spatial stiffness='100'><site site='on_it'/><site "
      "site='fixed'/></spatial></tendon>",
      "<tendon><fixed stiffness='100'><joint joint='px' coef='1'/></fixed></tendon>",
      "<actuator><position joint='px' kp='100'/></actuator>",
      "<actuator><general site='on_it' gear='0 0 1 0 0 0'/></actuator>",
      "<contact><pair geom1='ball' geom2='page'/></contact>"};
  const std::string proxy =
      "<site name='fixed'/><body><joint name='other' type='slide' axis='1 0 0'/>"
      "<geom size='0.01' pos='1 0 0'/></body><body name='moontrace_proxy'>"
      "<joint name='px' type='slide' axis='1 0 0'/><joint type='slide' axis='0 1 0'/>"
      "<joint type='slide' axis='0 0 1'/><site name='on_it'/>"
      "<geom name='ball' size='0.002' mass='0.05' contype='0' conaffinity='0'/>";
  const auto model = [&](const std::string& hanging, const std::string& sections) {
    std::string text = ModelWith("", proxy + hanging + "</body>");
    return text.insert(text.rfind("</mujoco>"), sections);
  };
  EXPECT_NO_THROW(LoadText(model("", "")));
  for (const std::string& sections : more) {
    const std::string text = LoadError(model("", sections));
    EXPECT_TRUE(IsOneLine(text)) << sections;
    EXPECT_TRUE(Holds(text, "m.xml: moontrace_proxy")) << sections << text;
  }
  const std::string hanging =
      "<body><joint type='hinge'/><geom size='0.002' contype='0' "
      "conaffinity='0'/></body>";
  EXPECT_TRUE(Holds(LoadError(model(hanging, "")), "a jointed body hangs on it"));
}

TEST_F(ModelLoader, KeyframesGrowWithTheProxy) {
  std::string xml = ModelWith("", "<body><joint type='slide'/><geom size='1'/></body>");
  xml.insert(xml.find("</mujoco>"), "<keyframe><key qpos='0.25' qvel='1'/></keyframe>");
  const LoadedModel loaded = LoadText(xml);
  EXPECT_EQ(loaded.m->nq, kInserted + 1);
  EXPECT_EQ(loaded.m->key_qpos[kInserted], 0.25);
  EXPECT_EQ(loaded.m->key_qpos[0], 0);
}

TEST_F(ModelLoader, IncludesAndMeshesAreFoundBesideTheModel) {
  Write("parts/page.xml",
        "<mujocoinclude><geom name='page' type='plane' size='1 1 1'/></mujocoinclude>");
  Write("parts/cup.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  const std::string path = Write(
      "model.xml",
      "<mujoco><compiler meshdir='parts'/><asset><mesh name='cup' file='cup.obj'/></asset>"
      "<custom><text name='moontrace:page' data='{}'/></custom><worldbody>"
      "<include file='parts/page.xml'/><geom type='mesh' mesh='cup' pos='0 0 -3'/></worldbody>"
      "</mujoco>");
  const Scene scene = Scene::Load(path, {});
  EXPECT_EQ(scene.model()->nmesh, 1);
  // its text stands alone
  const Scene again = Scene::FromXml(scene.model_xml(), "model.xml", {});
  EXPECT_EQ(again.model()->nmesh, 1);
  EXPECT_EQ(again.model_xml(), scene.model_xml());
}

TEST_F(ModelLoader, IncludesThatNeverEndAreRefused) {
  const std::string path = Write("model.xml", "<mujoco><include file='model.xml'/></mujoco>");
  EXPECT_TRUE(IsOneLine(ErrorOf([&] { Scene::Load(path, {}); })));
  const std::string missing = Write("other.xml", "<mujoco><include file='no.xml'/></mujoco>");
  EXPECT_TRUE(Holds(ErrorOf([&] { Scene::Load(missing, {}); }), "no.xml"));
}

TEST_F(ModelLoader, BrokenFilesGiveOneLineWithTheirName) {
  EXPECT_TRUE(Holds(LoadError("<mujoco>\n  <worldbody>\n</mujoco>"), "m.xml:3:"));
  EXPECT_TRUE(Holds(LoadError("<robot/>"), "no MuJoCo model"));
  const std::string schema = LoadError("<mujoco>\n\n<foo/></mujoco>");
  EXPECT_TRUE(Holds(schema, "foo") && Holds(schema, "line 3")) << schema;
  const std::string body = LoadError(ModelWith("", "<body><joint type='slide'/></body>"));
  EXPECT_TRUE(Holds(body, "mass")) << body;
  for (const char* xml : {"", "<mujoco>\n  <worldbody>\n</mujoco>", "<robot/>", "no xml",
                          "<mujoco>\n\n<foo/></mujoco>", "<mujoco/>", "<mujoco><worldbody/>"}) {
    const std::string text = LoadError(xml);
    EXPECT_TRUE(IsOneLine(text) && text.rfind("m.xml", 0) == 0) << xml << ": " << text;
  }
  EXPECT_TRUE(IsOneLine(LoadError(body)));
  EXPECT_TRUE(Holds(ErrorOf([] { Scene::Load("nowhere.xml", {}); }), "nowhere.xml"));
}

TEST_F(ModelLoader, HostileFilesEndInOneLine) {
  std::string deep = "<mujoco>";
  for (int i = 0; i < 100000; ++i) deep += "<body>";
  for (int i = 0; i < 100000; ++i) deep += "</body>";
  EXPECT_TRUE(IsOneLine(LoadError(deep + "</mujoco>")));
  std::string nested = ModelWith("", "");
  nested.replace(nested.find("{}"), 2, "{text=" + std::string(100000, '['));
  EXPECT_TRUE(IsOneLine(LoadError(nested)));
  const std::string names = "<body name='" + std::string(5000, 'n') + "'/>";
  const std::string repeated = LoadError(ModelWith("", names + names));
  EXPECT_TRUE(IsOneLine(repeated));
  EXPECT_LT(repeated.size(), 1000u);
}

TEST_F(ModelLoader, LabelsMustFindAGeomWithAChart) {
  EXPECT_TRUE(Holds(LoadError("<mujoco><worldbody><geom type='plane' size='1 1 1'/></worldbody>"
                              "</mujoco>"),
                    "no label"));
  const std::string unknown = LoadError(
      "<mujoco><custom><text name='moontrace:pge' data='{}'/></custom><worldbody>"
      "<geom name='page' type='plane' size='1 1 1'/></worldbody></mujoco>");
  EXPECT_TRUE(Holds(unknown, "'pge'") && Holds(unknown, "did you mean 'page'")) << unknown;
  std::string xml = ModelWith("",
                              "<geom name='ball' size='1'/>"
                              "<geom name='can' type='cylinder' size='0.03 0.05'/>");
  const auto labelled = [&xml](const std::string& geom, const std::string& data) {
    std::string text = xml;
    text.replace(text.find("moontrace:page"), 14, "moontrace:" + geom);
    return text.replace(text.find("\"{}\""), 4, "\"" + data + "\"");
  };
  EXPECT_EQ(LoadError(labelled("ball", "{}")), "");
  const std::string face = LoadError(labelled("can", "{face='left'}"));
  EXPECT_TRUE(Holds(face, "no face left; take top, bottom, round")) << face;
  const std::string off = LoadError(labelled("can", "{middle_mm=[0, 60]}"));
  EXPECT_TRUE(Holds(off, "middle_mm lies outside") && Holds(off, "-50 to 50 mm along y")) << off;
}

// Most models name bodies and leave their geoms without names.
TEST_F(ModelLoader, AGeomsOwnNameMayEndInAColonAndANumber) {
  const auto with = [](const std::string& geoms) {
    return "<mujoco><custom><text name='moontrace:k:2' data='{}'/></custom><worldbody>" + geoms +
           "</worldbody></mujoco>";
  };
  const std::string k = "<geom name='k' size='1'/>", k2 = "<geom name='k:2' size='1'/>";
  const Label own = LoadText(with(k + k2)).labels.front();
  EXPECT_EQ(own.carrier, 1);
  EXPECT_EQ(NameOf(own), "k:2");
  EXPECT_EQ(LoadText(with(k2)).labels.front().carrier, 0);
  const Label second = LoadText(with(k)).labels.front();
  EXPECT_EQ(second.geom, "k");
  EXPECT_EQ(second.number, 2);
}

TEST_F(ModelLoader, AGeomWithoutANameIsMeantByItsBody) {
  const auto with = [](const std::string& named) {
    return "<mujoco><custom><text name='moontrace:" + named +
           "' data='{}'/></custom><worldbody><body name='arm'><geom size='1'/></body>"
           "<body name='hand'><geom size='1'/><geom type='box' size='1 2 3'/></body></worldbody>"
           "</mujoco>";
  };
  EXPECT_EQ(LoadText(with("arm")).labels.front().carrier, 0);
  EXPECT_EQ(LoadText(with("hand/1:4")).labels.front().carrier, 1);
  EXPECT_EQ(LoadText(with("hand/2")).labels.front().carrier, 2);
  const std::string several = LoadError(with("hand"));
  EXPECT_TRUE(IsOneLine(several) && Holds(several, "has 2 geoms; write hand/1 to hand/2"));
  EXPECT_TRUE(Holds(LoadError(with("hand/3")), "no such geom"));
  EXPECT_TRUE(Holds(LoadError(with("hnd")), "did you mean 'hand'"));
}

TEST_F(ModelLoader, TiltsNoPageWhoseBodyCanMove) {
  const std::string xml =
      "<mujoco><custom><text name='moontrace:sheet' data='{}'/></custom><worldbody>"
      "<body>JOINT<geom name='sheet' type='box' size='0.1 0.1 0.01'/></body></worldbody></mujoco>";
  const auto with = [&xml](const std::string& joint) {
    return std::string(xml).replace(xml.find("JOINT"), 5, joint);
  };
  for (const char* joint : {"<freejoint/>", "<joint type='hinge'/>"}) {
    const std::string text = ErrorOf([&] { LoadModel(with(joint), "", "m.xml", 0.1); });
    EXPECT_TRUE(IsOneLine(text) && Holds(text, "m.xml: label on 'sheet': its body can move"))
        << text;
    EXPECT_EQ(LoadError(with(joint)), "");  // level it is taken
  }
  EXPECT_EQ(ErrorOf([&] { LoadModel(with(""), "", "m.xml", 0.1); }), "");
}

TEST_F(ModelLoader, SeveralLabelsAreKeptInOrderAndTheFirstIsFelt) {
  std::string xml = ModelWith("", "<geom name='lid' type='plane' pos='0 0 1' size='1 1 1'/>");
  xml.insert(xml.find("</custom>"), "<text name='moontrace:lid:1' data='{text=\"B\"}'/>");
  const LoadedModel loaded = LoadText(xml);
  ASSERT_EQ(loaded.labels.size(), 2u);
  EXPECT_EQ(loaded.labels[1].text, "B");
  EXPECT_TRUE(HasRemark(loaded.remarks, "2 labels"));
}

TEST_F(ModelLoader, ThePageBeginsWhereTheLabelSays) {
  std::string xml = ModelWith("", "");
  xml.replace(xml.find("{}"), 2, "{at_mm=[-30, 20]}");
  EXPECT_EQ(Scene::FromXml(xml, "m.xml", {}).X_WP().p, glm::dvec3(-0.03, 0.02, 0));
}

TEST_F(ModelLoader, SaysWhatItChanges) {
  Scene scene =
      Scene::FromXml(ModelWith("<option integrator='RK4' timestep='0.005'/>", ""), "m.xml", {});
  EXPECT_FALSE(HasRemark(scene.remarks(), "RK4"));  // that it is left to do
  EXPECT_TRUE(HasRemark(scene.remarks(), "time step"));
  EXPECT_EQ(scene.model()->opt.timestep, 0.001);
  EXPECT_TRUE(Scene::Load("", {}).remarks().empty());
}

TEST(MujocoError, EndsTheProgramWithOneLineInsteadOfWaitingForAKey) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto fail = [] {
    QuietMujoco();
    mju_error("out of everything");
  };
  EXPECT_EXIT(fail(), testing::ExitedWithCode(4), "^MuJoCo stopped: out of everything\n$");
}

}  // namespace
}  // namespace moontrace
