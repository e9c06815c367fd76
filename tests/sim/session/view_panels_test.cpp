#include "sim/session/view_panels.h"

#include <gtest/gtest.h>

#include <map>

#include "sim/session/loop_words.h"
#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

using Kind = PanelControl::Kind;

/// Every line that a control can say, its ends and all choices.
std::vector<std::string> LinesOf(const PanelControl& control) {
  std::vector<std::string> lines;
  if (control.kind == Kind::kButton) lines.push_back(LineOf(control, {}));
  if (control.kind == Kind::kSlider) {
    lines.push_back(LineOf(control, {control.low, 0, {}}));
    lines.push_back(LineOf(control, {control.high, 0, {}}));
  }
  if (control.kind == Kind::kChoice) {
    for (std::size_t i = 0; i < control.choices.size(); ++i) {
      lines.push_back(LineOf(control, {0, static_cast<int>(i), {}}));
    }
  }
  return lines;
}

TEST(LoopPanel, SaysWhatTheLoopUnderstands) {
  std::size_t said = 0;
  for (const PanelControl& control : LoopPanel()) {
    EXPECT_LE(control.label.size(), 20U);
    for (const std::string& line : LinesOf(control)) {
      const LoopLine read = ReadLoopLine(line);
      EXPECT_TRUE(read.word != LoopWord::kRefused && read.word != LoopWord::kNothing)
          << line << ": " << read.refusal;
      ++said;
    }
  }
  EXPECT_GT(said, 20U);
}

TEST(LoopPanel, ShowsThePageAsItIs) {
  TextSetup text;
  text.script = FindScript("moon");
  text.set.pages.resize(3);
  text.set.style.size = 0.02;
  text.set.style.relief = Relief::kEmbossed;
  PageForm form;
  form.depth = 0.5;
  form.pitch = 1.5;
  text.set.style.texture.paper.emplace().kind = PaperKind::kGrid;
  const std::vector<PanelControl> controls = LoopPanel();
  const std::vector<PanelValue> values = LoopPanelValues(text, form, 0.5, 1, "touching");
  ASSERT_EQ(values.size(), controls.size());
  const auto value_of = [&](const std::string& label) {
    PanelValue found;
    for (std::size_t i = 0; i < controls.size(); ++i) {
      if (controls[i].label == label && controls[i].kind != Kind::kHeading) found = values[i];
    }
    return found;
  };
  EXPECT_EQ(value_of("Page").text, "2 of 3");
  EXPECT_EQ(value_of("The tip").text, "touching");
  EXPECT_DOUBLE_EQ(value_of("Size").number, 20);
  EXPECT_DOUBLE_EQ(value_of("Depth").number, 50);
  EXPECT_DOUBLE_EQ(value_of("Width").number, 100);
  EXPECT_EQ(value_of("Letters").choice, 1);
  EXPECT_EQ(value_of("Form of H").choice, 0);  // Moon's own is the crescent
  EXPECT_DOUBLE_EQ(value_of("Line pitch").number, 150);
  EXPECT_NEAR(value_of("Tilt").number, 28.6479, 1e-4);  // half a radian
  EXPECT_EQ(value_of("Paper").choice, 2);
}

TEST(TrialPanel, HasAValueForEachControl) {
  const TrialTexts texts{"the moon", 0.012, "1 of 1", "2.0 s"};
  const std::vector<PanelValue> values = TrialPanelValues(texts);
  ASSERT_EQ(values.size(), TrialPanel().size());
  EXPECT_EQ(values[1].text, "the moon");
  EXPECT_EQ(values[2].text, "12 mm");
}

TEST(ReadingPanel, ShowsTheTraceThenTheReader) {
  TrialTexts texts{"the moon", 0.012, "1 of 1", "2.0 s"};
  texts.reading = {"the m", "o 93 %, c 7 %", "follows"};
  const std::vector<PanelControl> controls = ReadingPanel();
  const std::vector<PanelValue> values = TrialPanelValues(texts);
  ASSERT_EQ(values.size(), controls.size());
  std::map<std::string, std::string> shown;
  for (std::size_t i = 0; i < controls.size(); ++i) shown[controls[i].label] = values[i].text;
  EXPECT_EQ(shown["Text"], "the moon");
  EXPECT_EQ(shown["Read"], "the m");
  EXPECT_EQ(shown["Takes it for"], "o 93 %, c 7 %");
  EXPECT_EQ(shown["The hand"], "follows");
}

}  // namespace
}  // namespace moontrace
