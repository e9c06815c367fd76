#include "sim/setup/text_setup.h"

#include "tests/sim/cli_fixture.h"

namespace moontrace {
namespace {

class TextOnAModel : public CliTest {
 protected:
  /// A box of 100 by 50 mm, its upper face labelled from its corner, on `joint`.
  std::string Box(const std::string& label, const std::string& joint = "") const {
    WriteAll(In("box.xml"),
             "<mujoco><custom><text name='moontrace:face' data=\"{at_mm=[-50,-25], " + label +
                 "}\"/></custom><worldbody><body pos='0 0 0.1'>" + joint +
                 "<geom name='face' type='box' size='0.05 0.025 0.005'/></body></worldbody>"
                 "</mujoco>");
    return In("box.xml");
  }
};

TEST_F(TextOnAModel, ThatFallsAwayIsNeverTouchedAndHasNoErrors) {
  const std::string model = Box("text='LO', size_mm=12", "<freejoint/>");
  const nlohmann::json json = RunLine({"trace", "--model", model, "--json"}).Json();
  EXPECT_EQ(json["total"]["contact_share"], 0);
  EXPECT_EQ(json["total"]["coverage"], 0);
  for (const char* key : {"mean_error_mm", "rms_error_mm", "max_error_mm", "excursions", "bias_mm",
                          "dtw_mm", "direction", "order", "speed_accuracy_cost_mm_s"}) {
    EXPECT_TRUE(json["total"][key].is_null()) << key;
    EXPECT_TRUE(json["letters"][0][key].is_null()) << key;
  }
  const Outcome words = RunLine({"trace", "--model", model});
  EXPECT_EQ(words.out.rfind("Never touched the page", 0), 0U) << words.out;
  EXPECT_EQ(words.out.find("error"), std::string::npos) << words.out;
  EXPECT_EQ(words.out.find("Left the groove"), std::string::npos) << words.out;
}

TEST_F(TextOnAModel, ThatMovesHasNoForceBound) {
  const std::string joint = "<joint type='hinge' axis='0 1 0' damping='0.1' stiffness='1'/>";
  const std::string model = Box("text='LO', size_mm=12", joint);
  const Outcome words = RunLine({"trace", "--model", model});
  EXPECT_NE(words.err.find("The geom 'face' can move"), std::string::npos) << words.err;
  EXPECT_EQ(words.out.find("Force bound"), std::string::npos) << words.out;
  const nlohmann::json json = RunLine({"trace", "--model", model, "--json"}).Json();
  EXPECT_TRUE(json["total"]["force_bound_n"].is_null());
  const Outcome fixed = RunLine({"trace", "--model", Box("text='LO', size_mm=12")});
  EXPECT_EQ(fixed.err.find("can move"), std::string::npos) << fixed.err;
  EXPECT_NE(fixed.out.find("Force bound"), std::string::npos) << fixed.out;
}

TEST_F(TextOnAModel, HasTheModelsPaper) {
  const std::string model = Box("text='LO', size_mm=12");
  const Outcome plain = RunLine({"trace", "--model", model, "--json"});
  EXPECT_EQ(plain.Json()["paper"]["name"], "model");
  EXPECT_EQ(plain.err.find("--page"), std::string::npos) << plain.err;
  const Outcome larger = RunLine({"trace", "--model", model, "--page", "200x50"});
  EXPECT_NE(larger.err.find("--page is larger than the geom 'face'"), std::string::npos)
      << larger.err;
  const Outcome smaller = RunLine({"trace", "--model", model, "--page", "60x40", "--json"});
  EXPECT_EQ(smaller.Json()["paper"]["name"], "custom");
  EXPECT_EQ(smaller.Json()["paper"]["width_mm"], 60);
  EXPECT_EQ(smaller.err.find("--page"), std::string::npos) << smaller.err;
}

TEST_F(TextOnAModel, NeedsAText) {
  for (const char* label : {"size_mm=12", "text='', size_mm=12"}) {
    const std::string model = Box(label);
    const Outcome outcome = RunLine({"trace", "--model", model});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.err.rfind(model + ": label on 'face' has no text: ", 0), 0U) << outcome.err;
    EXPECT_EQ(RunLine({"trace", "L", "--model", model}).code, 0);
  }
}

TEST_F(TextOnAModel, ThatDoesNotFitIsToldByItsPages) {
  const std::string model = Box("text='LLL', size_mm=30");
  const Outcome outcome = RunLine({"trace", "--model", model});
  EXPECT_EQ(outcome.code, 0);
  const nlohmann::json json = RunLine({"trace", "--model", model, "--json"}).Json();
  ASSERT_GT(json["pages"], 1);
  EXPECT_EQ(outcome.err.find(std::to_string(json["pages"].get<int>()) + " pages: the text does"),
            outcome.err.find(" pages: the text does") - 1)
      << outcome.err;
  // by default the page begins in the middle of the face, and has a quarter of it
  EXPECT_EQ(outcome.err.find("middle_mm"), std::string::npos) << outcome.err;
  WriteAll(In("quarter.xml"),
           "<mujoco><custom><text name='moontrace:g' data=\"{text='LLL', size_mm=15}\"/></custom>"
           "<worldbody><geom name='g' type='box' size='0.05 0.025 0.005'/></worldbody></mujoco>");
  const Outcome quarter = RunLine({"trace", "--model", In("quarter.xml")});
  EXPECT_NE(quarter.err.find("middle_mm=[0,0]"), std::string::npos) << quarter.err;
  const Outcome fits = RunLine({"trace", "--model", Box("text='L', size_mm=30")});
  EXPECT_EQ(fits.err.find("pages"), std::string::npos) << fits.err;
}

TEST_F(TextOnAModel, HasTheModelsPunctuation) {
  const std::string model = Box("text='L?', size_mm=12, punctuation='older'");
  const nlohmann::json older = RunLine({"trace", "--model", model, "--json"}).Json();
  EXPECT_EQ(older["punctuation"], "older");
  EXPECT_EQ(older["letters"].size(), 3U);  // the mark, the letter, the short stop
  const nlohmann::json today =
      RunLine({"trace", "--model", model, "--punctuation", "today", "--json"}).Json();
  EXPECT_FALSE(today.contains("punctuation"));
  EXPECT_EQ(today["letters"].size(), 2U);
  const Outcome wrong = RunLine({"trace", "--model", Box("text='L?', punctuation='new'")});
  EXPECT_EQ(wrong.code, 3);
  EXPECT_NE(wrong.err.find("neither today nor older"), std::string::npos) << wrong.err;
}

TEST_F(TextOnAModel, InAnUnknownScriptNamesModelAndLabel) {
  const std::string model = Box("text='L', script='nope'");
  const Outcome outcome = RunLine({"trace", "--model", model});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err.rfind(model + ": label on 'face': ", 0), 0U) << outcome.err;
  EXPECT_NE(outcome.err.find("nope"), std::string::npos) << outcome.err;
  EXPECT_EQ(RunLine({"trace", "--model", model, "--script", "moon"}).code, 0);
}

TEST(TextOfAPage, IsOnOneLineWithBlanksForItsLineEnds) {
  TextSetup setup;
  setup.text = "the moon\nsea\n";
  PlacedGlyph first, last;
  first.source_begin = 4;
  last.source_end = 12;
  setup.set.pages.resize(2);
  setup.set.pages.front().glyphs = {first, last};
  EXPECT_EQ(TextOf(setup, 0), "moon sea");
  EXPECT_EQ(TextOf(setup, 1), "");
}

}  // namespace
}  // namespace moontrace
