// Scenes on a program's own model against those of Moontrace: the same to the last bit.
#include <cmath>
#include <cstring>
#include <sstream>
#include <vector>

#include "sim/console/console.h"
#include "sim/setup/text_trial.h"
#include "sim/setup/trial_parameters.h"
#include "sim/trial/metrics_json.h"
#include "sim/trial/record.h"
#include "tests/library/stepping/scene_fixture.h"

namespace moontrace {
namespace {

/// The same scene by the rooms of C++, as `moontrace trace --model` makes it.
struct Reference {
  explicit Reference(const std::string& path, const char* words) {
    TextRequest request;
    request.command = "trace";
    request.feel.model = path;
    if (words != nullptr) request.text.text = words;
    std::istringstream in;
    std::ostringstream out, err;
    Console console(in, out, err);
    text = SetUpText(request, console);
    setup = TrialOf(text, 0, request.feel, std::nullopt, 1);
  }
  TextSetup text;
  TrialSetup setup;
};

struct Case {
  const char* model;
  const char* words;  ///< none: the label's own
};
class SceneOnEveryModel : public testing::TestWithParam<Case> {};

TEST_P(SceneOnEveryModel, TracesAsTheProgramToTheLastBit) {
  OwnModel own(GetParam().model);
  const Reference reference(own.path, GetParam().words);
  const std::string theirs = (own.folder / "theirs").string();
  const std::string ours = (own.folder / "ours").string();
  const RecordRequest request{theirs, "{}", false};
  const TrialResult expected = RunTrial(reference.setup, &request);

  moontrace_scene_options options = SceneOptionsOf(GetParam().words);
  options.model_path = own.path.c_str();
  const OpenScene open(own, options);
  auto how = Sized<moontrace_trace_options>();
  how.record = ours.c_str();
  moontrace_trace* trace = nullptr;
  ASSERT_EQ(moontrace_trace_open(open.scene, own.m, own.d, &how, &trace), MOONTRACE_DONE)
      << moontrace_scene_message();
  auto facts = Sized<moontrace_trace_facts>();
  ASSERT_EQ(moontrace_trace_describe(trace, &facts), MOONTRACE_DONE);
  EXPECT_EQ(facts.json, ResultText(expected));
  EXPECT_EQ(facts.samples, expected.ticks);
  EXPECT_EQ(facts.coverage, expected.score.total.coverage);
  EXPECT_GT(facts.coverage, 0.5);
  const std::string samples = BytesOf(own.folder / "ours/samples.f64");
  EXPECT_FALSE(samples.empty());
  EXPECT_TRUE(samples == BytesOf(own.folder / "theirs/samples.f64"));
  EXPECT_EQ(BytesOf(own.folder / "ours/model.xml"), BytesOf(own.folder / "theirs/model.xml"));
  EXPECT_EQ(moontrace_trace_close(trace), MOONTRACE_DONE);

  // what `moontrace replay --check` does with it
  const Record record = ReadRecord(ours);
  const TrialParameters parameters = ReadParameters(record.head.parameters_json, ours);
  EXPECT_EQ(parameters.text, reference.text.text);
  const TextureField field =
      PageField(*reference.setup.page, *reference.setup.script, reference.setup.style, false);
  const ReplayResult replay = Replay(record, field, nullptr, {}, reference.setup.others);
  EXPECT_EQ(replay.first_difference, record.rows.size()) << replay.column;
}

/// Steps of a hand that sways over the page and into it.
TEST_P(SceneOnEveryModel, StepsAsTheProgramToTheLastBit) {
  OwnModel own(GetParam().model);
  Reference reference(own.path, GetParam().words);
  Scene scene = Scene::Load(own.path, reference.setup.scene);
  const TextureField field =
      PageField(*reference.setup.page, *reference.setup.script, reference.setup.style, false);
  scene.SetField(&field);
  for (const LaidLabel& other : reference.setup.others) scene.SetLabel(other);

  const OpenScene open(own, SceneOptionsOf(GetParam().words));
  const PlacedGlyph& first = reference.setup.page->glyphs.front();
  const double start[3] = {first.origin_P.x, first.origin_P.y + 0.004, 0.003};
  scene.Reset({start[0], start[1], start[2]});
  ASSERT_EQ(moontrace_scene_reset(open.scene, own.m, own.d, start), MOONTRACE_DONE);
  int touched = 0;
  for (int i = 0; i < 1500; ++i) {
    const double place[3] = {start[0] + 0.00001 * i, start[1], 0.001 + 0.002 * std::cos(0.005 * i)};
    double world[3];
    ASSERT_EQ(moontrace_scene_place(open.scene, own.m, own.d, place, world), MOONTRACE_DONE);
    const glm::dvec3 same = scene.PointOn({place[0], place[1], place[2]}).p_W;
    ASSERT_EQ(world[0], same.x);
    moontrace_scene_input input = HandAt(world[0], world[1], world[2]);
    auto felt = Sized<moontrace_scene_answer>();
    ASSERT_EQ(moontrace_scene_step(open.scene, own.m, own.d, &input, &felt), MOONTRACE_DONE)
        << moontrace_scene_message();
    DeviceState hand;
    hand.p_D = same;
    const TickResult expected = scene.Tick(hand);
    for (int k = 0; k < 3; ++k) {
      ASSERT_EQ(felt.force_world[k], expected.force_W[k]) << i;
      ASSERT_EQ(felt.proxy[k], expected.proxy_P[k]) << i;
    }
    touched += felt.in_contact != 0 ? 1 : 0;
    ASSERT_EQ(own.m->opt.timestep, 0.001);
  }
  EXPECT_GT(touched, 50);
  const auto nv = static_cast<std::size_t>(own.m->nv);
  EXPECT_EQ(std::memcmp(own.d->qvel, scene.data()->qvel, nv * sizeof(double)), 0);
  EXPECT_EQ(own.d->time, scene.data()->time);
}

INSTANTIATE_TEST_SUITE_P(Models, SceneOnEveryModel,
                         testing::Values(Case{"page.xml", "moon"}, Case{"mug.xml", nullptr},
                                         Case{"door.xml", nullptr}, Case{"panel.xml", nullptr},
                                         Case{"sign.xml", nullptr}),
                         [](const auto& of) {
                           const std::string name = of.param.model;
                           return name.substr(0, name.find('.'));
                         });

/// The bytes of a model, as MuJoCo saves them.
std::vector<char> BytesOf(const mjModel* m) {
  std::vector<char> bytes(static_cast<std::size_t>(mj_sizeModel(m)));
  mj_saveModel(m, nullptr, bytes.data(), static_cast<int>(bytes.size()));
  return bytes;
}

TEST(SceneModel, IsTheCallersAgainAfterEachCall) {
  OwnModel own("panel.xml");
  const std::vector<char> before = BytesOf(own.m);
  const OpenScene open(own, SceneOptionsOf());
  EXPECT_TRUE(BytesOf(own.m) == before);
  const moontrace_scene_input input = HandAt(0, 0, 0.3);
  auto felt = Sized<moontrace_scene_answer>();
  ASSERT_EQ(moontrace_scene_step(open.scene, own.m, own.d, &input, &felt), MOONTRACE_DONE);
  EXPECT_TRUE(BytesOf(own.m) == before);
  const double tip[3] = {0, 0, 0.01};
  ASSERT_EQ(moontrace_scene_reset(open.scene, own.m, own.d, tip), MOONTRACE_DONE);
  EXPECT_TRUE(BytesOf(own.m) == before);
}

TEST(SceneData, StayInTheStateThatTheyAreInWhenASceneIsOpened) {
  OwnModel own("door.xml");
  for (int i = 0; i < own.m->nv; ++i) own.d->qvel[i] = 0.1 * i;
  for (int i = 0; i < 20; ++i) mj_step(own.m, own.d);
  const std::vector<double> qpos(own.d->qpos, own.d->qpos + own.m->nq);
  const std::vector<double> qvel(own.d->qvel, own.d->qvel + own.m->nv);
  const double time = own.d->time;
  const OpenScene open(own, SceneOptionsOf());
  EXPECT_EQ(own.d->time, time);
  EXPECT_EQ(std::vector<double>(own.d->qpos, own.d->qpos + own.m->nq), qpos);
  EXPECT_EQ(std::vector<double>(own.d->qvel, own.d->qvel + own.m->nv), qvel);
}

TEST(SceneData, MayBeSteppedByTheCallerBetweenSteps) {
  OwnModel own("page.xml");
  const OpenScene open(own, SceneOptionsOf("moon"));
  auto felt = Sized<moontrace_scene_answer>();
  const moontrace_scene_input input = HandAt(0.005, 0.005, -0.0005);
  for (int i = 0; i < 300; ++i) {
    ASSERT_EQ(moontrace_scene_step(open.scene, own.m, own.d, &input, &felt), MOONTRACE_DONE);
  }
  // at rest two springs in a row: 0.5 mm by 1000 N/m each, half of it in the coupling
  EXPECT_NEAR(felt.force_world[2], 0.25, 0.01);
  mj_forward(own.m, own.d);
  ASSERT_EQ(moontrace_scene_step(open.scene, own.m, own.d, &input, &felt), MOONTRACE_DONE);
  EXPECT_NEAR(felt.force_world[2], 0.25, 0.01);
}

TEST(SceneFacts, AreThoseOfModelAndText) {
  OwnModel own("mug.xml");
  const OpenScene open(own, SceneOptionsOf());
  auto facts = Sized<moontrace_scene_facts>();
  ASSERT_EQ(moontrace_scene_describe(open.scene, &facts), MOONTRACE_DONE);
  EXPECT_EQ(facts.mujoco, mj_version());
  EXPECT_EQ(facts.labels, 2u);
  EXPECT_STREQ(facts.text, "MORNING TEA");
  EXPECT_EQ(facts.pages, 1u);
  EXPECT_EQ(facts.tick, 0.001);
  EXPECT_DOUBLE_EQ(facts.proxy_mass, 0.05);  // of models/proxy.xml
  EXPECT_TRUE(std::isfinite(facts.force_bound));
}

TEST(SceneText, HasTheStyleThatIsAskedFor) {
  OwnModel own("page.xml");
  auto style = Sized<moontrace_style>();
  style.embossed = 1;
  style.letter_size = 0.02;
  style.sheet = "60x50";
  moontrace_scene_options options = SceneOptionsOf("moon moon");
  options.style = &style;
  options.page = 1;
  const OpenScene open(own, options);
  auto facts = Sized<moontrace_scene_facts>();
  ASSERT_EQ(moontrace_scene_describe(open.scene, &facts), MOONTRACE_DONE);
  EXPECT_EQ(facts.width, 0.060);
  EXPECT_GT(facts.pages, 1u);
}

TEST(SceneTrace, GivesItsSamplesInPieces) {
  OwnModel own("page.xml");
  const OpenScene open(own, SceneOptionsOf("i"));
  moontrace_trace* trace = nullptr;
  ASSERT_EQ(moontrace_trace_open(open.scene, own.m, own.d, nullptr, &trace), MOONTRACE_DONE);
  auto facts = Sized<moontrace_trace_facts>();
  ASSERT_EQ(moontrace_trace_describe(trace, &facts), MOONTRACE_DONE);
  std::vector<double> time(facts.samples), force(3 * facts.samples), some(3 * 10);
  auto samples = Sized<moontrace_trace_samples>();
  samples.count = facts.samples;
  samples.time = time.data();
  samples.force = force.data();
  ASSERT_EQ(moontrace_trace_read(trace, &samples), MOONTRACE_DONE);
  samples.first = 200;
  samples.count = 10;
  samples.time = nullptr;
  samples.force = some.data();
  ASSERT_EQ(moontrace_trace_read(trace, &samples), MOONTRACE_DONE);
  EXPECT_EQ(std::memcmp(some.data(), force.data() + 600, sizeof(double) * some.size()), 0);
  for (std::size_t i = 1; i < time.size(); ++i) ASSERT_NEAR(time[i] - time[i - 1], 0.001, 1e-9);
  EXPECT_EQ(moontrace_trace_close(trace), MOONTRACE_DONE);
}

}  // namespace
}  // namespace moontrace
