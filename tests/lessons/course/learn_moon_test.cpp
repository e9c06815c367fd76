// The shipped course, as it stands in lessons/courses/learn-moon.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "lessons/course/course.h"
#include "lessons/course/lesson_order.h"
#include "lessons/course/taught_signs.h"
#include "textures/fonts/script.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

std::string Lines(const std::vector<CourseFault>& faults) {
  std::string lines;
  for (const CourseFault& fault : faults) lines += LineOf(fault) + "\n";
  return lines;
}

TEST(LearnMoon, IsSoundDownToSixMillimetres) {
  EXPECT_EQ(Lines(CheckCourse(LoadCourse("learn-moon"), 0.006)), "");
}

TEST(LearnMoon, GoesFromFortyToSixMillimetres) {
  const Course course = LoadCourse("learn-moon");
  EXPECT_DOUBLE_EQ(course.sizes.front(), 0.040);
  EXPECT_DOUBLE_EQ(course.sizes.back(), 0.006);
  EXPECT_TRUE(std::is_sorted(course.sizes.rbegin(), course.sizes.rend()));
}

TEST(LearnMoon, TeachesEverySignOfMoonExactlyOnce) {
  const Course course = LoadCourse("learn-moon");
  const Script moon = FindScript("moon");
  std::map<std::string, int> times;  // an item of one sign teaches it
  std::set<std::string> digits;
  std::map<std::string, int> numerals;  // lesson -> digits
  for (const Lesson& lesson : course.lessons) {
    for (const std::string& item : lesson.items) {
      const SignUse use = SignsOf(item, moon, lesson.grade, nullptr);
      EXPECT_TRUE(TeachesSigns(item, use)) << item;
      if (use.signs.size() == 1) ++times[use.signs.front()];
      if (use.signs.size() == 1) continue;
      ASSERT_EQ(use.signs.size(), 2U) << item;
      EXPECT_EQ(use.signs.front(), "numeral");
      EXPECT_TRUE(digits.insert(item).second) << item;
      ++numerals[lesson.id];
    }
  }
  EXPECT_EQ(digits.size(), 10U);
  EXPECT_EQ(numerals.size(), 1U) << "the numeral sign is introduced in one lesson";
  for (const auto& [sign, count] : times) EXPECT_EQ(count, 1) << sign;
  for (char letter = 'a'; letter <= 'z'; ++letter) EXPECT_EQ(times[std::string(1, letter)], 1);
  for (const char* sign :
       {"and", "th", "ch", "wh", "comma", "full-stop", "apostrophe", "quote", "exclamation",
        "question", "paren-open", "paren-close", "hyphen", "colon", "slash", "asterisk"}) {
    EXPECT_EQ(times[sign], 1) << sign;
  }
  // Nothing that a text could be written with is left out.
  for (const auto& sign : moon.signs) EXPECT_EQ(times[sign.second], 1) << sign.second;
  for (const Contraction& group : moon.contractions) {
    for (const std::string& sign : group.signs) EXPECT_EQ(times[sign], 1) << sign;
  }
}

TEST(LearnMoon, GivesAMemoryAidForEverythingItTeaches) {
  for (const Lesson& lesson : LoadCourse("learn-moon").lessons) {
    for (const std::string& item : lesson.items) EXPECT_EQ(lesson.hints.count(item), 1U) << item;
  }
}

TEST(LearnMoon, AsksMirrorMatesAgainstEachOther) {
  const Course course = LoadCourse("learn-moon");
  std::set<std::string> asked;
  for (const Lesson& lesson : course.lessons) {
    for (const Step& step : lesson.steps) {
      if (step.question == Question::kPick) asked.insert(step.items.begin(), step.items.end());
    }
  }
  // Mates inside the families of moon-script.md, section 10.
  for (const auto& [one, other] : std::map<std::string, std::string>{{"b", "j"},
                                                                     {"f", "g"},
                                                                     {"c", "d"},
                                                                     {"u", "w"},
                                                                     {"e", "m"},
                                                                     {"l", "y"},
                                                                     {"k", "x"},
                                                                     {"a", "v"},
                                                                     {"r", "s"},
                                                                     {"n", "z"},
                                                                     {"p", "q"}}) {
    EXPECT_EQ(course.mates.at(one), other);
    EXPECT_EQ(course.mates.at(other), one);
    EXPECT_TRUE(asked.count(one) > 0 && asked.count(other) > 0) << one << other;
  }
}

TEST(LearnMoon, NamesEveryShapeAndMarkThatIsAskedInWords) {
  const Course course = LoadCourse("learn-moon");
  const auto can_be_typed = [](const std::string& item) {
    return std::all_of(item.begin(), item.end(),
                       [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); });
  };
  for (const Lesson& lesson : course.lessons) {
    std::vector<std::string> items = lesson.items;
    for (const Step& step : lesson.steps) {
      items.insert(items.end(), step.items.begin(), step.items.end());
    }
    for (const std::string& item : items) {
      EXPECT_TRUE(can_be_typed(item) || course.names.count(item) > 0) << item;
    }
  }
}

TEST(LearnMoon, IsWalkedInTheOrderOfItsFile) {
  const Course course = LoadCourse("learn-moon");
  const LessonOrder order = OrderOf(course);
  ASSERT_EQ(order.walk.size(), course.lessons.size());
  for (std::size_t i = 0; i < order.walk.size(); ++i) EXPECT_EQ(order.walk[i], i);
}

/// What a desk-top device reaches holds each page, at the size that its step has then.
TEST(LearnMoon, FitsEachPageOnADeskTopDevice) {
  const Course course = LoadCourse("learn-moon");
  std::map<std::string, Script> scripts;
  for (const Lesson& lesson : course.lessons) {
    if (scripts.count(lesson.script) == 0) scripts[lesson.script] = FindScript(lesson.script);
    const Script& script = scripts[lesson.script];
    for (const Step& step : lesson.steps) {
      std::vector<std::string> texts = step.items;
      if (step.question == Question::kSame) {
        for (std::string& text : texts) text += " " + course.mates.at(text);
      }
      if (!step.text.empty()) texts.push_back(step.text);
      for (const std::string& text : texts) {
        TypeStyle style =
            DefaultStyle(step.size.value_or(course.sizes.back()), Relief::kEngraved, script);
        style.grade = lesson.grade;
        if (step.one_page) style.line_pitch *= 0.9;  // a step that a lesson's stage takes
        const Typeset typeset = SetText(text, script, style, FindPage("workspace"));
        EXPECT_EQ(typeset.pages.size(), 1U) << lesson.id << ": " << text;
        if (step.question == Question::kSame) continue;  // may lie one below the other
        const auto ends = std::count(text.begin(), text.end(), '\n');
        EXPECT_EQ(typeset.pages[0].lines, 1 + static_cast<std::size_t>(ends))
            << lesson.id << ": a line is broken: " << text;
      }
    }
  }
}

TEST(LearnMoon, HasANoteOfFourLinesAtSixteenMillimetresAfterTenLetters) {
  const Course course = LoadCourse("learn-moon");
  std::set<std::string> letters;
  for (const Lesson& lesson : course.lessons) {
    letters.insert(lesson.items.begin(), lesson.items.end());
    for (const Step& step : lesson.steps) {
      if (!step.one_page) continue;
      EXPECT_EQ(letters.size(), 10U);
      EXPECT_EQ(step.kind, StepKind::kRead);
      EXPECT_DOUBLE_EQ(step.size.value_or(0), 0.016);
      EXPECT_EQ(std::count(step.text.begin(), step.text.end(), '\n'), 3);
      EXPECT_EQ(lesson.steps.back().kind, StepKind::kTest);
      return;
    }
  }
  FAIL() << "no note";
}

TEST(LearnMoon, HasALineOfOnesOwnToReadByTheTenthLetter) {
  const Course course = LoadCourse("learn-moon");
  std::size_t letters = 0;
  for (const Lesson& lesson : course.lessons) {
    letters += lesson.items.size();
    for (const Step& step : lesson.steps) {
      // words with a space between, to be read for oneself
      if (step.kind != StepKind::kRead || step.text.find(' ') == std::string::npos) continue;
      EXPECT_LE(letters, 10U) << lesson.id;
      return;
    }
  }
  FAIL() << "no line";
}

// A page is what is turned under the hand, and what a print counts: a text may have several.
TEST(LearnMoon, NumbersNoPagesOfItsOwn) {
  for (const Lesson& lesson : LoadCourse("learn-moon").lessons) {
    for (const Step& step : lesson.steps) {
      for (const char* words : {"Page ", "pages"}) {
        EXPECT_EQ(step.say.find(words), std::string::npos) << lesson.id << ": " << step.say;
      }
    }
  }
}

TEST(LearnMoon, BidsNobodyLiftWhoCannot) {
  for (const Lesson& lesson : LoadCourse("learn-moon").lessons) {
    for (const Step& step : lesson.steps) {
      const std::string& said = step.say_held.empty() ? step.say : step.say_held;
      for (const char* word : {"lift", "Lift", "ower it", "stylus", "pencil"}) {
        EXPECT_EQ(said.find(word), std::string::npos) << lesson.id << ": " << word;
      }
    }
  }
}

// A mouse has no handle, pushes nobody, and presses with its button only.
TEST(LearnMoon, TellsWhoCannotLiftNothingThatIsUntrueOfAMouse) {
  const Lesson first = LoadCourse("learn-moon").lessons.front();
  const std::string& said = first.steps.front().say_held;
  for (const char* word : {"handle", "need not press", "always on", "every push"}) {
    EXPECT_EQ(said.find(word), std::string::npos) << word;
  }
}

TEST(LearnMoon, SpeaksOfNothingThatNeedsSight) {
  for (const Lesson& lesson : LoadCourse("learn-moon").lessons) {
    for (const Step& step : lesson.steps) {
      for (const char* word : {"look at", "see ", "screen", "picture", "colour", "click"}) {
        // A picture frame is a thing that a hand knows.
        if (std::string(word) == "picture" && lesson.id == "hands") continue;
        EXPECT_EQ((step.say + step.say_held).find(word), std::string::npos)
            << lesson.id << ": " << word;
      }
    }
  }
}

}  // namespace
}  // namespace moontrace
