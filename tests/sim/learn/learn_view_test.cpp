#include "sim/learn/learn_view.h"

#include <gtest/gtest.h>

#include <variant>

#include "sim/tutor/tutor_command.h"

namespace moontrace {
namespace {

using Kind = PanelControl::Kind;

TEST(LearnPanel, SaysWhatTheTutorsDeskUnderstands) {
  std::size_t said = 0;
  for (const PanelControl& control : LearnPanel()) {
    EXPECT_LE(control.label.size(), 20U);
    if (control.kind == Kind::kHeading || control.kind == Kind::kText) continue;
    const std::size_t choices = control.kind == Kind::kChoice ? control.choices.size() : 1;
    for (std::size_t i = 0; i < choices; ++i) {
      const std::string line = LineOf(control, {control.high, static_cast<int>(i), {}});
      if (line == "stop") continue;  // the lesson's own
      EXPECT_TRUE(std::holds_alternative<TutorCommand>(ReadTutorCommand(line))) << line;
      ++said;
    }
  }
  EXPECT_GT(said, 25U);
}

}  // namespace
}  // namespace moontrace
