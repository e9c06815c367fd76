#include "sim/view/panel.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

PanelControl Slider(double low, double high, double step, const char* unit) {
  PanelControl slider;
  slider.kind = PanelControl::Kind::kSlider;
  slider.word = "size";
  slider.low = low;
  slider.high = high;
  slider.step = step;
  slider.unit = unit;
  return slider;
}

std::string Said(const PanelControl& slider, double number) {
  return LineOf(slider, {number, 0, {}});
}

TEST(PanelLine, SliderSaysWordNumberAndUnit) {
  EXPECT_EQ(Said(Slider(5, 40, 1, "mm"), 20), "size 20 mm");
  EXPECT_EQ(Said(Slider(0, 10, 1, ""), 7), "size 7");
}

TEST(PanelLine, SliderKeepsToItsSteps) {
  EXPECT_EQ(Said(Slider(5, 40, 1, "mm"), 19.6), "size 20 mm");
  EXPECT_EQ(Said(Slider(0.1, 2, 0.1, "mm"), 0.30000000000000004), "size 0.3 mm");
  EXPECT_EQ(Said(Slider(0, 3, 0.25, ""), 1.3), "size 1.25");
  EXPECT_EQ(Said(Slider(-30, 60, 5, "degrees"), -1), "size 0 degrees");
}

TEST(PanelLine, SliderKeepsWithinItsEnds) {
  EXPECT_EQ(Said(Slider(5, 40, 1, "mm"), 100), "size 40 mm");
  EXPECT_EQ(Said(Slider(5, 40, 1, "mm"), -1), "size 5 mm");
  EXPECT_EQ(Said(Slider(0, 1, 0.3, ""), 1), "size 0.9");  // the highest whole step
}

TEST(PanelLine, ChoiceSaysItsWordAndWhatIsChosen) {
  PanelControl choice;
  choice.kind = PanelControl::Kind::kChoice;
  choice.word = "mode";
  choice.choices = {"attract", "bead", "rail"};
  EXPECT_EQ(LineOf(choice, {0, 2, {}}), "mode rail");
  EXPECT_EQ(LineOf(choice, {0, -1, {}}), "");
  EXPECT_EQ(LineOf(choice, {0, 3, {}}), "");
  choice.word.clear();
  EXPECT_EQ(LineOf(choice, {0, 1, {}}), "bead");
}

TEST(PanelLine, ButtonSaysItsWordAndTextNothing) {
  PanelControl control;
  control.kind = PanelControl::Kind::kButton;
  control.word = "again";
  EXPECT_EQ(LineOf(control, {}), "again");
  control.kind = PanelControl::Kind::kText;
  EXPECT_EQ(LineOf(control, {}), "");
}

}  // namespace
}  // namespace moontrace
