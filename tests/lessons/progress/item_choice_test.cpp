#include "lessons/progress/item_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/lessons/lesson_fixture.h"

namespace moontrace {
namespace {

constexpr std::int64_t kDay = 86400;

/// At a step that asks for names, of items that were introduced and traced at the first size.
class ItemChoice : public testing::Test {
 protected:
  ItemChoice() {
    course_ = SmallCourse();
    course_.lessons = {MakeLesson("01", {"a", "b", "c", "d"},
                                  {MakeStep(StepKind::kTrace), MakeStep(StepKind::kRecognise),
                                   MakeStep(StepKind::kTest)}),
                       MakeLesson("02", {"x", "y"}, {MakeStep(StepKind::kRecognise)})};
    progress_.lesson = "01";
    progress_.step = 1;
    for (const char* item : {"a", "b", "c", "d"}) {
      ItemProgress& known = progress_.items[item];
      known.introduced = true;
      known.coverages = {1, 1};
      known.errors = {0, 0};
    }
  }
  /// Past the first size, still to be named at the next.
  void Pass(const std::string& item) { progress_.items[item].size_step = 1; }
  NextItem Choose() {
    const auto next = ChooseItem(course_, progress_, chooser_);
    EXPECT_TRUE(next.has_value());
    if (!next) return {};
    chooser_.last = next->item;
    chooser_.last_traced = next->task == StepKind::kTrace;
    return *next;
  }
  std::map<std::string, int> Count(int choices) {
    std::map<std::string, int> counts;
    for (int i = 0; i < choices; ++i) ++counts[Choose().item];
    return counts;
  }

  Course course_;
  Progress progress_;
  ItemChooser chooser_;
};

TEST_F(ItemChoice, TwoEnterFirstAndTheNextWhenBothArePastTheFirstSize) {
  EXPECT_EQ(Count(100), (std::map<std::string, int>{{"a", 50}, {"b", 50}}));
  Pass("a");
  std::map<std::string, int> counts = Count(100);
  EXPECT_EQ(counts.count("c"), 0u) << "b is not past the first size";
  Pass("b");
  counts = Count(100);
  EXPECT_GT(counts["c"], 0);
  EXPECT_EQ(counts.count("d"), 0u);
  Pass("c");
  EXPECT_GT(Count(100)["d"], 0);
}

// Chances by weight: all wrong 6/7, all right 1/7, so without the rule against repetition the weak
// one of four would come 6 times in 9. With it: of each other item's successor, and never itself;
// the share p of the weak one solves p = (1 - p) (6/7) / (8/7), so p = 3/7.
TEST_F(ItemChoice, WeakOnesComeMoreOften) {
  for (const char* item : {"a", "b", "c", "d"}) {
    Pass(item);
    progress_.items[item].named.assign(5, item[0] != 'b');
  }
  const int choices = 4000;
  const double share = Count(choices)["b"] / static_cast<double>(choices);
  // Standard deviation below sqrt(0.25 / 4000) = 0.008; four of them.
  EXPECT_NEAR(share, 3.0 / 7, 0.032);
}

TEST_F(ItemChoice, NoneComesTwiceInARow) {
  for (const char* item : {"a", "b", "c", "d"}) Pass(item);
  std::string last;
  for (int i = 0; i < 500; ++i) {
    const std::string item = Choose().item;
    EXPECT_NE(item, last);
    last = item;
  }
}

TEST_F(ItemChoice, WhatWentWrongComesBackAfterOneOther) {
  for (const char* item : {"a", "b", "c", "d"}) Pass(item);
  for (int i = 0; i < 50; ++i) {
    chooser_.last = "d";
    chooser_.queue = {"d"};
    EXPECT_NE(Choose().item, "d");
    EXPECT_EQ(Choose().item, "d");
    EXPECT_TRUE(chooser_.queue.empty());
  }
}

// Four known items stand beside four open ones: a quarter of the questions is about them, half when
// too few answers are right of late.
TEST_F(ItemChoice, KnownItemsAreKeptAliveAndMakeItEasierWhenItIsHard) {
  course_.lessons[1].items = {"v", "w", "x", "y"};
  for (const char* item : {"a", "b", "c", "d", "v", "w", "x", "y"}) {
    Pass(item);
    progress_.items[item].introduced = true;
  }
  const auto known_share = [&] {
    const int choices = 4000;
    std::map<std::string, int> counts = Count(choices);
    return (counts["v"] + counts["w"] + counts["x"] + counts["y"]) / static_cast<double>(choices);
  };
  progress_.recent.assign(20, true);
  // Standard deviations sqrt(p (1 - p) / 4000), below 0.008; four of them.
  EXPECT_NEAR(known_share(), 0.25, 0.032);
  progress_.recent.assign(20, false);
  EXPECT_NEAR(known_share(), 0.5, 0.032);
}

// After it a known one comes always, after a known one it comes three times in four: its share p
// solves p = (1 - p) 3/4.
TEST_F(ItemChoice, OneItemAloneComesAmongKnownOnesElseItsNameNeedsNoFeeling) {
  course_.lessons[0].items = {"a"};
  progress_.items["x"].introduced = true;
  Pass("x");
  const int choices = 4000;
  EXPECT_NEAR(Count(choices)["a"] / static_cast<double>(choices), 3.0 / 7, 0.032);
}

TEST_F(ItemChoice, AnItemIsTracedAtTheFirstSizeBeforeItIsNamed) {
  Pass("b");
  progress_.items["b"].coverages.clear();
  progress_.items["b"].errors.clear();
  progress_.items["a"].coverages.clear();
  progress_.items["a"].errors.clear();
  for (int i = 0; i < 50; ++i) {
    const NextItem next = Choose();
    EXPECT_EQ(next.task, next.item == "a" ? StepKind::kTrace : StepKind::kRecognise);
  }
}

TEST_F(ItemChoice, ANewItemIsDemonstratedFirst) {
  progress_.items["a"].introduced = false;
  progress_.step = 0;
  NextItem next = Choose();
  EXPECT_EQ(next.item, "a");
  EXPECT_EQ(next.task, StepKind::kDemonstrate);
  progress_.items["a"].introduced = true;
  EXPECT_EQ(Choose().task, StepKind::kTrace);
}

TEST_F(ItemChoice, ATestAsksEachItemOnceInSomeOrder) {
  progress_.step = 2;
  std::vector<std::string> asked;
  for (int i = 0; i < 4; ++i) {
    const NextItem next = Choose();
    EXPECT_EQ(next.task, StepKind::kTest);
    asked.push_back(next.item);
    progress_.here[next.item] = {1, {true}, {}};
  }
  std::sort(asked.begin(), asked.end());
  EXPECT_EQ(asked, (std::vector<std::string>{"a", "b", "c", "d"}));
  EXPECT_FALSE(ChooseItem(course_, progress_, chooser_).has_value());
}

TEST_F(ItemChoice, SkippedItemsDoNotComeBack) {
  chooser_.skipped = {"a", "c"};
  EXPECT_EQ(Count(100).count("a"), 0u);
  EXPECT_EQ(Count(100).count("c"), 0u);
  chooser_.skipped = {"a", "b", "c", "d"};
  EXPECT_FALSE(ChooseItem(course_, progress_, chooser_).has_value());
}

TEST_F(ItemChoice, IsTheSameForTheSameSeed) {
  for (const char* item : {"a", "b", "c", "d"}) Pass(item);
  std::vector<std::string> first, second;
  chooser_.random = 42;
  for (int i = 0; i < 100; ++i) first.push_back(Choose().item);
  chooser_ = {};
  chooser_.random = 42;
  for (int i = 0; i < 100; ++i) second.push_back(Choose().item);
  EXPECT_EQ(first, second);
}

TEST_F(ItemChoice, DueItemsComeByHowLikelyTheyAreForgottenAndNotTooMany) {
  const std::int64_t now = 1'700'000'000;
  const auto remember = [&](const char* item, double stability, std::int64_t days) {
    ItemProgress& known = progress_.items[item];
    known.introduced = true;
    known.stability = stability;
    known.difficulty = 5;
    known.reviewed = now - days * kDay;
    known.due = known.reviewed + static_cast<std::int64_t>(stability) * kDay;
  };
  remember("a", 10, 10);  // recall 0.9
  remember("b", 1, 30);
  remember("c", 10, 5);  // not due
  remember("d", 3, 9);
  EXPECT_EQ(DueItems(course_, progress_, now), (std::vector<std::string>{"b", "d", "a"}));
  course_.mastery.reviews = 1;
  EXPECT_EQ(DueItems(course_, progress_, now), std::vector<std::string>{"b"});
  progress_.step = 2;
  EXPECT_TRUE(DueItems(course_, progress_, now).empty()) << "the test asks for them";
}

// Reference values of SplitMix64 seeded with 1234567 (Vigna's splitmix64.c).
TEST(SeededRandom, IsSplitMix) {
  std::uint64_t random = 1234567;
  EXPECT_EQ(NextRandom(random), 6457827717110365317u);
  EXPECT_EQ(NextRandom(random), 3203168211198807973u);
  EXPECT_EQ(NextRandom(random), 9817491932198370423u);
}

}  // namespace
}  // namespace moontrace
