// What the lesson machine says, in words.

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "lessons/course/lesson_items.h"
#include "sim/console/word_messages.h"
#include "sim/console/wording.h"
#include "sim/learn/learn_messages.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

namespace {

using lesson_action::Sentence;

std::string Millimetres(double size) { return Short(kMillimetres * size, 1) + " mm"; }

std::string HelpSentence(double help) {
  if (help <= 0) return "No help now: nothing pushes.";
  return fmt::format("Help {} of 10 now.", Short(std::round(help), 0));
}

/// Of a trace that was not good: how much of the sign it followed, or that it kept too far from it.
std::string Missing(double coverage, double wanted) {
  constexpr std::pair<double, const char*> kParts[] = {
      {0.1, "next to nothing of it"}, {0.4, "less than half of it"}, {0.6, "about half of it"}};
  if (coverage >= wanted) return "stay closer to the line";
  for (const auto& [most, words] : kParts) {
    if (!(coverage >= most)) return words;
  }
  return "most of it, not all";
}

/// What stands before a word, which is no sign of the course, where it is named.
std::string_view BeforeWord(const Course& course, std::string_view item) {
  const bool pair = item.find('\n') != std::string_view::npos;
  return pair || item.size() < 2 || IsTaught(course, item) ? "" : "the word ";
}

// Each of the parts below knows some of the sentences, and is silent about the others.

/// How a course, a lesson or a test goes on.
std::string OfCourse(const Course& course, const lesson_action::Say& sentence) {
  const std::string text = Called(course, sentence.text);
  switch (sentence.sentence) {
    case Sentence::kWelcome:
      return fmt::format("Welcome to {}.", OneLine(sentence.text));
    case Sentence::kWelcomeBack:
      if (sentence.of == 0) return fmt::format("Welcome back, to: {}.", OneLine(sentence.text));
      return fmt::format("Welcome back, to lesson {} of {}: {}.", sentence.number, sentence.of,
                         OneLine(sentence.text));
    case Sentence::kLesson:
      if (sentence.of == 0) return fmt::format("Lesson: {}.", OneLine(sentence.text));
      return fmt::format("Lesson {} of {}: {}.", sentence.number, sentence.of,
                         OneLine(sentence.text));
    case Sentence::kOfferLesson:
      return fmt::format("Practice for the hands: say lesson {}.", sentence.number);
    case Sentence::kCourseText:
      return sentence.text;  // its lines are said one by one
    case Sentence::kTestBegins:
      return "A test: no help, results at the end.";
    case Sentence::kTestResult:
      return fmt::format("Test done: {} of {} right.", sentence.number, sentence.of);
    case Sentence::kTestAgain:
      return "Not passed: practice, then once more.";
    case Sentence::kReviewDue:
      return fmt::format("To review: {}.",
                         Counted(static_cast<std::size_t>(sentence.number), "sign", "signs"));
    case Sentence::kLessonDone:
      return fmt::format("Lesson done: {}.", OneLine(sentence.text));
    case Sentence::kCourseDone:
      return "Course done: every lesson is behind you.";
    case Sentence::kBreak:
      return fmt::format("Time for a break: {} worked. Quit keeps all; or go on.",
                         Counted(static_cast<std::size_t>(sentence.number), "minute", "minutes"));
    case Sentence::kLessonLeft:
      return fmt::format("Lesson left for later: {}.", OneLine(sentence.text));
    case Sentence::kSkipped:
      return text.empty() ? "Skipped, not sure yet."
                          : fmt::format("Skipped, not sure yet: {}.", text);
    case Sentence::kNoWayBack:
      return "No way back from a question: again asks it once more, next leaves it.";
    case Sentence::kNoTextBefore:
      return "Nothing before this in the lesson. The word lessons tells the others.";
    case Sentence::kNoSuchLesson:
      return fmt::format("No such lesson: {}.", Unstopped(OneLine(sentence.text, 20)));
    case Sentence::kLastLesson:
      return "This is the last lesson. Say lessons for all of them.";
    default:
      return {};
  }
}

/// What is to be done now.
std::string OfTask(const Course& course, const lesson_action::Say& sentence) {
  const std::string text = Called(course, sentence.text), other = Called(course, sentence.other);
  switch (sentence.sentence) {
    case Sentence::kNewItem:
      return fmt::format("New: {}.", text);
    case Sentence::kOnWith:
      return fmt::format("On with {}.", text);
    case Sentence::kHint:
      return fmt::format("Hint: {}", OneLine(sentence.text, 500));
    case Sentence::kNoHint:
      return sentence.number > 0 ? "No hint while it is asked." : "No hint for this one.";
    case Sentence::kAnother:
      return sentence.number == 2 ? "Two new ones." : "A new one.";
    case Sentence::kAskName:
      return "What is it? Say its name.";
    case Sentence::kAskPick:
      return fmt::format("Is it {} or {}?", text, other);
    case Sentence::kAskSame:
      return "Two signs: same or different?";
    case Sentence::kTraceIt:
      if (sentence.number > 0) return fmt::format("Trace {}; say done at its end.", text);
      return fmt::format("Trace {}; lift when done.", text);
    case Sentence::kProbe:
      return "This one without help.";
    case Sentence::kExploreIt:
      return "Feel the page; say next to go on.";
    case Sentence::kReadIt:
      return "Read the page; say next to go on.";
    case Sentence::kNotLearnt:
      return fmt::format("Not learnt yet: {}.", OneLine(sentence.text, 100));
    case Sentence::kLedAlong:
      return fmt::format("Let your hand be led: {}.", text);
    default:
      return {};
  }
}

/// What became of an answer or a trace.
std::string OfOutcome(const Course& course, const lesson_action::Say& sentence) {
  const std::string text = Called(course, sentence.text), other = Called(course, sentence.other);
  switch (sentence.sentence) {
    case Sentence::kRight:
      return fmt::format("Right: {}.", text);
    case Sentence::kWrong:
      // "it is it" would be no sentence
      return fmt::format("Wrong: it is {}{}, you said {}.", BeforeWord(course, sentence.text), text,
                         other);
    case Sentence::kTold:
      return fmt::format("It is {}{}.", BeforeWord(course, sentence.text), text);
    case Sentence::kNotAnAnswer:
      return fmt::format("{} is no answer. Say I don't know, and I tell you.",
                         Unstopped(OneLine(text, 20)));
    case Sentence::kTraceGood:
      return fmt::format("Good: {}.", text);
    case Sentence::kTraceBad:
      return fmt::format("Not yet: {}, {}.", text,
                         Missing(sentence.value, course.mastery.coverage));
    case Sentence::kSure:
      return fmt::format("Sure: {}.", text);
    case Sentence::kNotAsked:
      return fmt::format("Nothing is asked now: {}.", Unstopped(OneLine(sentence.text, 16)));
    case Sentence::kNotNow:
      return "No trace is awaited now.";
    case Sentence::kCannotPractise:
      if (sentence.number > 0) {
        return fmt::format("Not learnt yet: {} comes in lesson {}.", text, sentence.number);
      }
      return fmt::format("No sign learned so far: {}.", Unstopped(OneLine(sentence.text, 20)));
    default:
      return {};
  }
}

/// Size, help, push and speed.
std::string OfChange(const Course& course, const lesson_action::Say& sentence) {
  const std::string text = Called(course, sentence.text);
  switch (sentence.sentence) {
    case Sentence::kSmallerNow:
      return fmt::format("Smaller now: {}, {}.", text, Millimetres(sentence.value));
    case Sentence::kLargerAgain:
      return fmt::format("Larger again: {}, {}.", text, Millimetres(sentence.value));
    case Sentence::kHelpNow:
      return HelpSentence(sentence.value);
    case Sentence::kSpeedNow:
      return fmt::format("Speed {} times the usual now.", Short(sentence.value, 2));
    case Sentence::kLargestSize:
      return fmt::format("Letters of {} now, the largest.", Millimetres(sentence.value));
    case Sentence::kSmallestSize:
      return fmt::format("Letters of {} now, the smallest.", Millimetres(sentence.value));
    case Sentence::kSizeNow:
      return fmt::format("Letters of {} now.", Millimetres(sentence.value));
    case Sentence::kModeNow:
      return fmt::format("Push now: {}.", OneLine(sentence.text));
    case Sentence::kByRules:
      return "By the rules again: size, help and push.";
    case Sentence::kCannotLarger:
      return "No larger: these are the largest.";
    case Sentence::kCannotSmaller:
      return "No smaller: these are the smallest.";
    case Sentence::kNoMoreHelp:
      return "No more help: it is at its most.";
    case Sentence::kNoLessHelp:
      return "No less help: there is none now.";
    case Sentence::kNoHelpHere:
      return "No push while it is to be recognised.";
    default:
      return {};
  }
}

}  // namespace

std::string Called(const Course& course, std::string_view item) {
  const auto feed = item.find('\n');
  if (feed == std::string_view::npos) return OneLine(NameOf(course, item));
  return fmt::format("{} and {}", OneLine(NameOf(course, item.substr(0, feed))),
                     OneLine(NameOf(course, item.substr(feed + 1))));
}

std::string LessonSentence(const Course& course, const lesson_action::Say& sentence) {
  std::string words = OfTask(course, sentence);
  if (words.empty()) words = OfOutcome(course, sentence);
  if (words.empty()) words = OfChange(course, sentence);
  if (words.empty()) words = OfCourse(course, sentence);
  return words;
}

std::string BriefSentence(const Course& course, const lesson_action::Say& sentence) {
  const std::string text = Called(course, sentence.text);
  switch (sentence.sentence) {
    case Sentence::kWelcome:
    case Sentence::kWelcomeBack:
    case Sentence::kCourseText:
    case Sentence::kHint:
    case Sentence::kReviewDue:
      return {};
    case Sentence::kAskName:
      return "What is it?";
    case Sentence::kAskSame:
      return "Same or different?";
    case Sentence::kTraceIt:
      return fmt::format("Trace {}.", text);
    case Sentence::kProbe:
      return "No help.";
    case Sentence::kExploreIt:
      return "Feel.";
    case Sentence::kReadIt:
      return "Read.";
    case Sentence::kLedAlong:
      return fmt::format("Led: {}.", text);
    case Sentence::kRight:
      return "Right.";
    case Sentence::kWrong:
      return fmt::format("Wrong: {}.", text);
    case Sentence::kTraceGood:
      return "Good.";
    case Sentence::kTraceBad:
      return "Not yet.";
    default:
      return LessonSentence(course, sentence);
  }
}

std::string DemonstrationSentence(const Course& course, const lesson_action::Say& sentence) {
  using lesson_action::Sentence;
  switch (sentence.sentence) {
    case Sentence::kLedAlong:
    case Sentence::kTraceIt:
      return fmt::format("The program's hand traces {}.", Called(course, sentence.text));
    case Sentence::kExploreIt:
    case Sentence::kReadIt:
      return "The program's hand goes over the page; say next to go on.";
    default:
      return {};
  }
}

}  // namespace moontrace::say
