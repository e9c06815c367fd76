// Labels on every kind of geom, from a model's file to the trace of a hand: the shipped samples,
// and what is wrong with a label in one line each.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "lessons/measure/intended_strokes.h"
#include "sim/physics/scene.h"
#include "sim/setup/text_setup.h"
#include "tests/sim/cli_fixture.h"
#include "tests/source_path.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

class LabelsOfAModel : public CliTest {
 protected:
  /// A model with these labels, elements of <custom>, and geoms.
  std::string Model(const std::string& labels, const std::string& world) const {
    WriteAll(In("model.xml"), "<mujoco><custom>" + labels + "</custom><worldbody>" + world +
                                  "</worldbody></mujoco>");
    return In("model.xml");
  }
  static std::string Label(const std::string& name, const std::string& data) {
    return "<text name='moontrace:" + name + "' data=\"{" + data + "}\"/>";
  }
  /// The line of an error with exit code 3, without the file's name.
  std::string Refused(const std::string& model, std::vector<std::string> more = {}) {
    std::vector<std::string> line = {"trace", "--model", model};
    line.insert(line.end(), more.begin(), more.end());
    const Outcome outcome = RunLine(line);
    EXPECT_EQ(outcome.code, 3) << outcome.out;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    const std::size_t at = outcome.err.find("model.xml: ");
    EXPECT_NE(at, std::string::npos) << outcome.err;
    return at == std::string::npos ? "" : outcome.err.substr(at + 11);
  }
};

const char kBall[] = "<geom name='ball' type='sphere' size='0.05'/>";
const char kPlate[] = "<geom name='plate' type='box' size='0.05 0.03 0.01'/>";

// The whole way: every label of a shipped sample is set, laid, and traced by the simulated hand.
class SlowSamples : public LabelsOfAModel, public testing::WithParamInterface<const char*> {};
TEST_P(SlowSamples, AreTracedOnEveryLabel) {
  const std::string model = SourcePath(std::string("models/") + GetParam() + ".xml");
  const nlohmann::json json =
      RunLine({"trace", "--model", model, "--label", "all", "--json"}).Json();
  ASSERT_FALSE(json["labels"].empty());
  for (const nlohmann::json& label : json["labels"]) {
    EXPECT_GE(label["total"]["coverage"].get<double>(), 0.97) << GetParam() << label["label"];
    EXPECT_EQ(label["total"]["faults"], 0);
  }
}
INSTANTIATE_TEST_SUITE_P(Models, SlowSamples,
                         testing::Values("mug", "globe", "dice", "door", "panel"),
                         [](const auto& model) { return std::string(model.param); });

TEST_F(LabelsOfAModel, AreTracedOnARoundGeom) {
  const std::string model = Model(Label("ball", "text='LC', size_mm=12"), kBall);
  const nlohmann::json json = RunLine({"trace", "--model", model, "--json"}).Json();
  EXPECT_GE(json["total"]["coverage"].get<double>(), 0.97);
}

TEST_F(LabelsOfAModel, AreReplayedToTheBit) {
  const std::string model =
      Model(Label("can", "text='I', size_mm=8") + Label("can:2", "text='O', face='top', size_mm=8"),
            "<geom name='can' type='cylinder' size='0.03 0.02'/>");
  ASSERT_EQ(RunLine({"trace", "--model", model, "--label", "can", "--record", In("run")}).code, 0);
  EXPECT_EQ(RunLine({"replay", In("run"), "--check"}).code, 0);
}

// Length of a line of text over the surface, point after point in the world, against the page's.
TEST_F(LabelsOfAModel, HaveTheirTypesetLength) {
  for (const char* geom : {"type='cylinder' size='0.04 0.05'", "type='sphere' size='0.06'"}) {
    const std::string model = Model(Label("it", "text='MORNING TEA', size_mm=12"),
                                    "<geom name='it' " + std::string(geom) + "/>");
    std::istringstream in;
    std::ostringstream out, err;
    Console console(in, out, err);
    TextRequest request;
    request.feel.model = model;
    const TextSetup text = SetUpText(request, console);
    Scene scene = Scene::Load(model, OnLabel(text, 0, {}));
    const std::vector<IntendedStroke> strokes =
        IntendedStrokes(text.set.pages.front(), text.script, text.set.style);
    double page = 0, surface = 0;
    for (const IntendedStroke& stroke : strokes) {
      for (const Piece& piece : stroke.spine_P) {
        constexpr int kSteps = 500;
        const double length = Length(piece);
        glm::dvec3 last = scene.PointOn({PointAt(piece, 0), 0}).p_W;
        for (int i = 1; i <= kSteps; ++i) {
          const glm::dvec3 next = scene.PointOn({PointAt(piece, length * i / kSteps), 0}).p_W;
          surface += glm::distance(last, next);
          last = next;
        }
        page += length;
      }
    }
    EXPECT_NEAR(surface / page, 1, 0.01) << geom;
  }
}

TEST_F(LabelsOfAModel, AreRefusedInOneLineEach) {
  EXPECT_EQ(Refused(Model(Label("bal", "text='A'"), kBall)),
            "label on 'bal': no such geom; did you mean 'ball'?\n");
  EXPECT_EQ(Refused(Model(Label("ball", "text='A', face='top'"), kBall)),
            "label on 'ball': that geom has no face top; take round\n");
  const std::string large =
      Refused(Model(Label("plate", "text='A LONG NAME FOR IT', middle_mm=[0,0]"), kPlate));
  EXPECT_EQ(large.rfind("label on 'plate': its text has no room there: with size_mm ", 0), 0U)
      << large;
  // a text that goes on over pages is not told as large as its first
  EXPECT_NE(large.find(" pages, the first of "), std::string::npos) << large;
  const std::string together = Refused(
      Model(Label("ball", "text='AB'") + Label("ball:2", "text='C', middle_mm=[5,0]"), kBall));
  EXPECT_EQ(together, "labels 'ball:2' and 'ball' lie on one place: move one of them\n");
  const std::string two = Refused(Model(
      Label("ball", "text='A', stiffness_n_per_m=500") + Label("ball:2",
                                                               "text='B', stiffness_n_per_m=900, "
                                                               "middle_mm=[60,0]"),
      kBall));
  EXPECT_EQ(two.rfind("labels on 'ball' ask for two values of stiffness_n_per_m", 0), 0U) << two;
  const std::string signless = Refused(Model(Label("ball", "text='😀'"), kBall));
  EXPECT_EQ(signless.rfind("label on 'ball': ", 0), 0U) << signless;
  EXPECT_EQ(Refused(Model(Label("ball", "text='A'"), kBall), {"--label", "bal"}),
            "no label 'bal': did you mean 'ball'?\n");
}

// Wherever the label lies, whether it is the one that is felt, and only where it is at fault.
TEST_F(LabelsOfAModel, AreNamedWithTheLettersTheyCannotHave) {
  const std::string other = "<geom name='other' type='box' pos='0 0 1' size='0.05 0.03 0.01'/>";
  const std::pair<const char*, const char*> wrong[] = {
      {"grade=7", "script moon has no grade 7: "},
      {"slant_deg=80", "letters of slant 80 degrees"},
      {"size_mm=90", "page: 54 mm within its margins"},
      {"depth_mm=9", "groove depth 9 mm is too steep"}};
  for (const auto& [letters, what] : wrong) {
    for (const char* place : {"at_mm=[-50,-30]", "middle_mm=[0,0]"}) {
      const std::string label = Label("plate", std::string("text='it', ") + place + ", " + letters);
      const std::string named = std::string("label on 'plate': ") + what;
      EXPECT_EQ(Refused(Model(label, kPlate)).rfind(named, 0), 0U) << letters << place;
      const std::string second = Label("other", "text='it'") + label;
      EXPECT_EQ(Refused(Model(second, kPlate + other)).rfind(named, 0), 0U) << letters << place;
    }
  }
  const std::string model = Model(Label("plate", "text='it', at_mm=[-50,-30]"), kPlate);
  const Outcome asked =
      RunLine({"trace", "--model", model, "--slant-deg", "30", "--depth-mm", "9"});
  EXPECT_EQ(asked.code, 3);
  EXPECT_EQ(asked.err.rfind("groove depth 9 mm is too steep", 0), 0U) << asked.err;
}

TEST_F(LabelsOfAModel, AreNamedOnlyWithAModel) {
  EXPECT_EQ(RunLine({"trace", "A", "--label", "ball"}).code, 2);
  EXPECT_EQ(RunLine({"trace", "A", "--label", "all"}).code, 2);
  const std::string model = Model(Label("ball", "text='A'"), kBall);
  EXPECT_EQ(RunLine({"recognise", "--model", model, "--label", "all"}).code, 2);
}

}  // namespace
}  // namespace moontrace
