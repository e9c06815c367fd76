#include "sim/learn/learn_stage.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace moontrace {
namespace {

class LearnStageTest : public testing::Test {
 protected:
  LearnStageTest() : console_(in_, out_, out_), stage_(Simulated(), console_) {}

  static StageOptions Simulated() {
    StageOptions options;
    options.live.device = "simulated";
    return options;
  }
  /// Lets `lines` lines of 16 mm letters be felt. Pages that they take.
  std::size_t Show(int lines, bool one_page) {
    lesson_action::Show show;
    show.script = "moon";
    show.size = 0.016;
    show.one_page = one_page;
    for (int i = 0; i < lines; ++i) show.text += i == 0 ? "to it" : "\nto it";
    stage_.Show(show);
    return stage_.session().text().set.pages.size();
  }

  std::istringstream in_;
  std::ostringstream out_;
  Console console_;
  LearnStage stage_;
};

// A4 has 267 mm between its margins: nine lines at 1.8 em of 16 mm take 246, ten take 275.
TEST_F(LearnStageTest, LinesThatShareAPageComeCloserBeforeLettersAreSmaller) {
  EXPECT_EQ(Show(9, false), 1U);
  EXPECT_EQ(Show(10, false), 2U);
  EXPECT_EQ(Show(10, true), 1U);
  EXPECT_FALSE(stage_.shrunk());
  EXPECT_DOUBLE_EQ(stage_.size(), 0.016);
  EXPECT_EQ(Show(9, true), 1U);
  EXPECT_NEAR(stage_.session().text().set.style.line_pitch, 1.8 * 0.016, 1e-9) << "as usual again";
}

TEST_F(LearnStageTest, LettersAreSmallerWhereCloserLinesAreNotEnough) {
  EXPECT_EQ(Show(14, true), 1U);
  EXPECT_TRUE(stage_.shrunk());
  EXPECT_LT(stage_.size(), 0.016);
  EXPECT_GE(stage_.session().text().set.style.line_pitch, 1.5 * stage_.size());
}

}  // namespace
}  // namespace moontrace
