// What callers of the stepping library do wrong is answered by a code and a sentence.
#include <limits>
#include <thread>

#include "tests/library/stepping/scene_fixture.h"

namespace moontrace {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void ExpectRefused(int answer, int code, const char* words) {
  EXPECT_EQ(answer, code) << words;
  EXPECT_NE(std::string(moontrace_scene_message()).find(words), std::string::npos)
      << moontrace_scene_message();
}
void ExpectBadCall(int answer, const char* words) {
  ExpectRefused(answer, MOONTRACE_BAD_CALL, words);
}

void ExpectNotOpened(const OwnModel& own, const moontrace_scene_options& options, int code,
                     const char* words) {
  moontrace_scene* scene = nullptr;
  ExpectRefused(moontrace_scene_open(own.m, own.d, &options, &scene), code, words);
  EXPECT_EQ(scene, nullptr);
}

TEST(SceneMisuse, NullIsRefusedEverywhere) {
  OwnModel own("page.xml");
  const OpenScene open(own, SceneOptionsOf("moon"));
  const moontrace_scene_options options = SceneOptionsOf("moon");
  moontrace_scene* scene = nullptr;
  moontrace_trace* trace = nullptr;
  auto felt = Sized<moontrace_scene_answer>();
  auto facts = Sized<moontrace_scene_facts>();
  auto trace_facts = Sized<moontrace_trace_facts>();
  auto samples = Sized<moontrace_trace_samples>();
  const moontrace_scene_input input = HandAt(0, 0, 0);
  double three[3] = {};
  ExpectBadCall(moontrace_scene_open(nullptr, own.d, &options, &scene), "m is NULL");
  ExpectBadCall(moontrace_scene_open(own.m, nullptr, &options, &scene), "d is NULL");
  ExpectBadCall(moontrace_scene_open(own.m, own.d, nullptr, &scene), "options is NULL");
  ExpectBadCall(moontrace_scene_open(own.m, own.d, &options, nullptr), "scene is NULL");
  ExpectBadCall(moontrace_scene_describe(nullptr, &facts), "scene is NULL");
  ExpectBadCall(moontrace_scene_describe(open.scene, nullptr), "facts is NULL");
  ExpectBadCall(moontrace_scene_step(nullptr, own.m, own.d, &input, &felt), "scene is NULL");
  ExpectBadCall(moontrace_scene_step(open.scene, nullptr, own.d, &input, &felt), "are NULL");
  ExpectBadCall(moontrace_scene_step(open.scene, own.m, nullptr, &input, &felt), "are NULL");
  ExpectBadCall(moontrace_scene_step(open.scene, own.m, own.d, nullptr, &felt), "input is NULL");
  ExpectBadCall(moontrace_scene_step(open.scene, own.m, own.d, &input, nullptr), "answer is NULL");
  ExpectBadCall(moontrace_scene_reset(nullptr, own.m, own.d, three), "scene is NULL");
  ExpectBadCall(moontrace_scene_reset(open.scene, own.m, own.d, nullptr), "tip is NULL");
  ExpectBadCall(moontrace_scene_place(open.scene, own.m, own.d, nullptr, three), "place is NULL");
  ExpectBadCall(moontrace_scene_place(open.scene, own.m, own.d, three, nullptr), "world is NULL");
  ExpectBadCall(moontrace_trace_open(nullptr, own.m, own.d, nullptr, &trace), "scene is NULL");
  ExpectBadCall(moontrace_trace_open(open.scene, own.m, own.d, nullptr, nullptr), "trace is NULL");
  ExpectBadCall(moontrace_trace_describe(nullptr, &trace_facts), "trace is NULL");
  ExpectBadCall(moontrace_trace_read(nullptr, &samples), "trace is NULL");
  EXPECT_EQ(moontrace_scene_close(nullptr), MOONTRACE_DONE);
  EXPECT_EQ(moontrace_trace_close(nullptr), MOONTRACE_DONE);
}

TEST(SceneMisuse, AnotherMujocoIsRefusedBeforeTheModelIsLookedAt) {
  auto options = SceneOptionsOf("moon");
  moontrace_scene* scene = nullptr;
  for (const int other : {0, mjVERSION_HEADER - 1, mjVERSION_HEADER + 1, 3012000, -1}) {
    options.mujoco = other;
    // an address of nothing: looking at it would end the test
    auto* nothing = reinterpret_cast<mjModel*>(8);
    ExpectRefused(moontrace_scene_open(nothing, reinterpret_cast<mjData*>(8), &options, &scene),
                  MOONTRACE_WRONG_MUJOCO, std::to_string(mjVERSION_HEADER).c_str());
    ExpectRefused(moontrace_scene_check(MOONTRACE_MUJOCO_INTERFACE, other), MOONTRACE_WRONG_MUJOCO,
                  "compiled for");
  }
  EXPECT_EQ(moontrace_scene_check(MOONTRACE_MUJOCO_INTERFACE, mjVERSION_HEADER), MOONTRACE_DONE);
  ExpectBadCall(moontrace_scene_check(MOONTRACE_MUJOCO_INTERFACE + 1, mjVERSION_HEADER),
                "interface");
  EXPECT_EQ(moontrace_scene_mujoco(), mj_version());
}

TEST(SceneMisuse, AModelThatCarriesNoTextIsRefused) {
  const auto without = [](const std::string& word, const std::string& other) {
    return [=](std::string& xml) {
      for (std::size_t at = 0; (at = xml.find(word, at)) != std::string::npos; at += other.size())
        xml.replace(at, word.size(), other);
    };
  };
  const OwnModel no_label("page.xml", without("moontrace:page", "something"));
  ExpectNotOpened(no_label, SceneOptionsOf("moon"), MOONTRACE_BAD_INPUT, "no label");
  const OwnModel no_proxy("page.xml", without("\"moontrace_proxy\"", "\"ball\""));
  ExpectNotOpened(no_proxy, SceneOptionsOf("moon"), MOONTRACE_BAD_INPUT, "no body moontrace_proxy");
  const OwnModel own("page.xml");
  ExpectNotOpened(own, SceneOptionsOf(), MOONTRACE_BAD_INPUT, "text");
  auto options = SceneOptionsOf("moon");
  options.label = 3;
  ExpectNotOpened(own, options, MOONTRACE_BAD_INPUT, "label 3 of 1");
  options = SceneOptionsOf("moon");
  options.page = 1;
  ExpectNotOpened(own, options, MOONTRACE_BAD_CALL, "no page 1");
  options = SceneOptionsOf("moon");
  options.friction = 100;
  ExpectNotOpened(own, options, MOONTRACE_BAD_INPUT, "friction");
  options = SceneOptionsOf("moon");
  options.coupling_stiffness = 1e9;
  ExpectNotOpened(own, options, MOONTRACE_BAD_INPUT, "");
  options = SceneOptionsOf("moon");
  options.stiffness = kNan;
  ExpectNotOpened(own, options, MOONTRACE_BAD_CALL, "options.stiffness");
  options = SceneOptionsOf("moon");
  options.model_path = "no-such-model.xml";
  ExpectNotOpened(own, options, MOONTRACE_BAD_INPUT, "no-such-model.xml");
  options = SceneOptionsOf("moon");
  options.size = 4;
  ExpectNotOpened(own, options, MOONTRACE_BAD_CALL, "options.size");
}

TEST(SceneMisuse, AHandThatIsNowhereIsRefusedAndNothingStepped) {
  OwnModel own("page.xml");
  const OpenScene open(own, SceneOptionsOf("moon"));
  for (const double bad : {kNan, std::numeric_limits<double>::infinity()}) {
    moontrace_scene_input input = HandAt(0, bad, 0);
    auto felt = Sized<moontrace_scene_answer>();
    felt.depth = 9;
    ExpectBadCall(moontrace_scene_step(open.scene, own.m, own.d, &input, &felt), "input.position");
    EXPECT_EQ(felt.depth, 0);
    EXPECT_EQ(own.d->time, 0);
    input = HandAt(0, 0, 0);
    input.velocity_known = 1;
    input.velocity[2] = bad;
    ExpectBadCall(moontrace_scene_step(open.scene, own.m, own.d, &input, &felt), "input.velocity");
    const double tip[3] = {bad, 0, 0};
    double world[3];
    ExpectBadCall(moontrace_scene_reset(open.scene, own.m, own.d, tip), "tip");
    ExpectBadCall(moontrace_scene_place(open.scene, own.m, own.d, tip, world), "place");
  }
}

TEST(SceneMisuse, AStateThatIsNoNumberIsAFaultWithoutForce) {
  OwnModel own("mug.xml", [](std::string& xml) {
    const std::string word = "<body name=\"mug\" pos=\"0 0 0.05\">";
    const std::size_t at = xml.find(word);
    ASSERT_NE(at, std::string::npos);
    xml.insert(at + word.size(), "<freejoint/>");
  });
  const OpenScene open(own, SceneOptionsOf());
  const moontrace_scene_input input = HandAt(0, -0.0395, 0.05);
  auto felt = Sized<moontrace_scene_answer>();
  ASSERT_EQ(moontrace_scene_step(open.scene, own.m, own.d, &input, &felt), MOONTRACE_DONE);
  own.d->qvel[0] = kNan;
  ExpectRefused(moontrace_scene_step(open.scene, own.m, own.d, &input, &felt), MOONTRACE_BAD_INPUT,
                "not finite");
  EXPECT_EQ(felt.fault, 1u);
  EXPECT_EQ(felt.force_world[1], 0);
  // MuJoCo put its state back: it goes on
  EXPECT_EQ(moontrace_scene_step(open.scene, own.m, own.d, &input, &felt), MOONTRACE_DONE);
}

TEST(SceneMisuse, AnotherModelIsRefused) {
  OwnModel own("page.xml"), other("mug.xml");
  const OpenScene open(own, SceneOptionsOf("moon"));
  const moontrace_scene_input input = HandAt(0, 0, 0.01);
  auto felt = Sized<moontrace_scene_answer>();
  ExpectBadCall(moontrace_scene_step(open.scene, other.m, own.d, &input, &felt), "another model");
  ExpectBadCall(moontrace_scene_step(open.scene, own.m, other.d, &input, &felt), "another model");
  own.m->opt.timestep = 0.002;
  ExpectBadCall(moontrace_scene_step(open.scene, own.m, own.d, &input, &felt), "time step");
  own.m->opt.timestep = 0.001;
  EXPECT_EQ(moontrace_scene_step(open.scene, own.m, own.d, &input, &felt), MOONTRACE_DONE);
}

TEST(SceneMisuse, DataMadeAnewAreRefused) {
  OwnModel own("page.xml");
  const OpenScene open(own, SceneOptionsOf("moon"));
  mj_deleteData(own.d);
  own.d = nullptr;
  mjData* const anew = mj_makeData(own.m);
  own.d = anew;
  const moontrace_scene_input input = HandAt(0, 0, 0.01);
  auto felt = Sized<moontrace_scene_answer>();
  // whether at the same address or not, it is told or it is sound: never a crash
  const int answer = moontrace_scene_step(open.scene, own.m, anew, &input, &felt);
  EXPECT_TRUE(answer == MOONTRACE_BAD_CALL || answer == MOONTRACE_DONE)
      << moontrace_scene_message();
}

TEST(SceneMisuse, AClosedHandleIsRefused) {
  OwnModel own("page.xml");
  const auto options = SceneOptionsOf("i");
  moontrace_scene* scene = nullptr;
  ASSERT_EQ(moontrace_scene_open(own.m, own.d, &options, &scene), MOONTRACE_DONE);
  moontrace_trace* trace = nullptr;
  ASSERT_EQ(moontrace_trace_open(scene, own.m, own.d, nullptr, &trace), MOONTRACE_DONE);
  ASSERT_EQ(moontrace_scene_close(scene), MOONTRACE_DONE);
  const moontrace_scene_input input = HandAt(0, 0, 0.01);
  auto felt = Sized<moontrace_scene_answer>();
  ExpectBadCall(moontrace_scene_step(scene, own.m, own.d, &input, &felt), "no scene that is open");
  ExpectBadCall(moontrace_scene_close(scene), "no scene that is open");
  // a handle of another kind
  auto* wrong = reinterpret_cast<moontrace_scene*>(trace);
  ExpectBadCall(moontrace_scene_step(wrong, own.m, own.d, &input, &felt), "no scene that is open");
  auto facts = Sized<moontrace_trace_facts>();
  ASSERT_EQ(moontrace_trace_describe(trace, &facts), MOONTRACE_DONE);  // it outlives the scene
  auto samples = Sized<moontrace_trace_samples>();
  samples.first = facts.samples;
  samples.count = 1;
  ExpectBadCall(moontrace_trace_read(trace, &samples), "the trace has");
  samples.first = std::numeric_limits<std::size_t>::max();
  ExpectBadCall(moontrace_trace_read(trace, &samples), "the trace has");
  ASSERT_EQ(moontrace_trace_close(trace), MOONTRACE_DONE);
  ExpectBadCall(moontrace_trace_close(trace), "no trace that is open");
}

TEST(SceneMisuse, ARecordOfAnUnknownModelOrInATakenFolderIsRefused) {
  OwnModel own("page.xml");
  auto how = Sized<moontrace_trace_options>();
  const std::string folder = (own.folder / "record").string();
  how.record = folder.c_str();
  moontrace_trace* trace = nullptr;
  {
    const OpenScene open(own, SceneOptionsOf("i"));
    ExpectBadCall(moontrace_trace_open(open.scene, own.m, own.d, &how, &trace), "model_path");
  }
  auto options = SceneOptionsOf("i");
  options.model_path = own.path.c_str();
  const OpenScene open(own, options);
  std::filesystem::create_directories(folder + "/taken");
  ExpectRefused(moontrace_trace_open(open.scene, own.m, own.d, &how, &trace), MOONTRACE_BAD_INPUT,
                "record");
  EXPECT_EQ(trace, nullptr);
}

/// What a program's own callback does in the middle of a step.
std::function<void()> in_a_step;
void CallIt(const mjModel* /*m*/, mjData* /*d*/) {
  if (in_a_step) in_a_step();
}

/// A model that has an actuator, so that MuJoCo calls a program's control.
struct ControlledModel : OwnModel {
  ControlledModel()
      : OwnModel("page.xml", [](std::string& xml) {
          xml.insert(xml.find("</worldbody>"),
                     "<body name='arm'><joint name='arm' type='hinge'/>"
                     "<geom size='0.01' contype='0' conaffinity='0'/></body>");
          xml.insert(xml.find("</mujoco>"), "<actuator><motor joint='arm'/></actuator>");
        }) {
    mjcb_control = CallIt;
  }
  ~ControlledModel() {
    mjcb_control = nullptr;
    in_a_step = nullptr;
  }
  ControlledModel(const ControlledModel&) = delete;
  ControlledModel& operator=(const ControlledModel&) = delete;
};

TEST(SceneMisuse, AnErrorWithinMujocoEndsTheStepNotTheProgram) {
  const ControlledModel own;
  const OpenScene open(own, SceneOptionsOf("moon"));
  const moontrace_scene_input input = HandAt(0.005, 0.005, 0.01);
  auto felt = Sized<moontrace_scene_answer>();
  in_a_step = [] { mju_error("this model is broken"); };
  ExpectRefused(moontrace_scene_step(open.scene, own.m, own.d, &input, &felt), MOONTRACE_FAULT,
                "this model is broken");
  EXPECT_EQ(own.m->opt.timestep, 0.001);
  in_a_step = nullptr;
  ExpectRefused(moontrace_scene_step(open.scene, own.m, own.d, &input, &felt), MOONTRACE_FAULT,
                "reset the scene");
  const double tip[3] = {0.005, 0.005, 0.01};
  EXPECT_EQ(moontrace_scene_reset(open.scene, own.m, own.d, tip), MOONTRACE_DONE);
  EXPECT_EQ(moontrace_scene_step(open.scene, own.m, own.d, &input, &felt), MOONTRACE_DONE);
  // in the middle of a trace too
  int steps = 0;
  in_a_step = [&steps] {
    if (++steps == 500) mju_error("later it broke");
  };
  moontrace_trace* trace = nullptr;
  ExpectRefused(moontrace_trace_open(open.scene, own.m, own.d, nullptr, &trace), MOONTRACE_FAULT,
                "later it broke");
  EXPECT_EQ(trace, nullptr);
  EXPECT_EQ(own.m->opt.timestep, 0.001);
}

TEST(SceneThreads, ASecondThreadInOneSceneIsTold) {
  const ControlledModel own;
  const OpenScene open(own, SceneOptionsOf("moon"));
  int asked = 0;
  in_a_step = [&] {
    ++asked;
    std::thread([&open] {
      auto facts = Sized<moontrace_scene_facts>();
      ExpectBadCall(moontrace_scene_describe(open.scene, &facts), "another thread is in a call");
    }).join();
  };
  const moontrace_scene_input input = HandAt(0.005, 0.005, 0.01);
  auto felt = Sized<moontrace_scene_answer>();
  EXPECT_EQ(moontrace_scene_step(open.scene, own.m, own.d, &input, &felt), MOONTRACE_DONE);
  EXPECT_GT(asked, 0);
}

TEST(SceneThreads, ScenesOfTwoModelsAreSteppedAtOnce) {
  const auto step = [] {
    const OwnModel own("page.xml");
    const OpenScene open(own, SceneOptionsOf("moon"));
    auto felt = Sized<moontrace_scene_answer>();
    const moontrace_scene_input input = HandAt(0.005, 0.005, -0.0005);
    for (int i = 0; i < 300; ++i) {
      ASSERT_EQ(moontrace_scene_step(open.scene, own.m, own.d, &input, &felt), MOONTRACE_DONE);
    }
    EXPECT_NEAR(felt.force_world[2], 0.25, 0.01);  // two springs of 1000 N/m share 0.5 mm
  };
  std::thread other(step);
  step();
  other.join();
}

}  // namespace
}  // namespace moontrace
