#include "sim/learn/learn_tutor_messages.h"

#include <fmt/core.h>

#include "lessons/course/lesson_items.h"
#include "sim/console/wording.h"
#include "textures/base/text_file.h"
#include "textures/base/units.h"

namespace moontrace::say {

std::string TutorGreeting(std::string_view learner) {
  return fmt::format("Lesson of {}. Say where for what goes on, ? for the words.",
                     OneLine(learner));
}

std::string TutorWordsHelp() {
  return "help 7 is the push, from 0 to 10. Behind mode, say, lesson and find stands a word too, "
         "as "
         "in mode bead, say well done, lesson 5, find moon.";
}

std::string TutorsInWindow() {
  return "The panel is the tutor's. So are, typed here: size 20, help 7, mode bead, say TEXT, and "
         "what else only tutors have.";
}
std::string NothingRests() { return "Nothing rests: the lesson goes on."; }
std::string LessonNotFound(const Course& course, std::string_view given, bool tutor) {
  const bool number = given.find_first_not_of("0123456789") == std::string_view::npos;
  const std::size_t all = course.lessons.size(), in_order = LessonsInOrder(course);
  return fmt::format("{}: {}. Say a number from 1 to {}{}.{}",
                     number ? "No such lesson" : "No such lesson, or several", OneLine(given, 20),
                     in_order, all > in_order ? fmt::format(", or {} beside the course", all) : "",
                     tutor ? "" : " The word lessons tells them.");
}
namespace {

std::string InWords(const PushNow& push) {
  if (push.led) {
    if (push.help < 0) return "the hand is led to the end";
    return push.help == 0
               ? "the hand is led to the end, then no help"
               : fmt::format("the hand is led to the end, then help {} of 10", push.help);
  }
  if (push.mode == GuidanceMode::kOff || push.help <= 0) return "no push";
  return fmt::format("not led, help {} of 10, push {}", push.help, NameOf(push.mode));
}

}  // namespace

std::string PageAndHelp(double size, const PushNow& push) {
  return fmt::format("Letters {} mm, {}{}.", Short(kMillimetres * size, 1), InWords(push),
                     push.set ? ", in part set by hand" : "");
}

std::string LastTrials(const Course& course, const Trial& right, const Trial& wrong) {
  if (right.item.empty() && wrong.item.empty()) return "Nothing right or wrong yet today.";
  const auto named = [&course](const Trial& trial) {
    const ItemPair pair = PairOf(trial.item);
    std::string name = OneLine(NameOf(course, pair.first));
    if (!pair.second.empty()) name += " beside " + OneLine(NameOf(course, pair.second));
    if (trial.kind == StepKind::kTrace) {
      return fmt::format("{} traced, {}", name, Percent(trial.coverage));
    }
    if (trial.right) return name;
    if (trial.answer.empty()) return name + " not known";
    return fmt::format("{} taken for {}", name, OneLine(NameOf(course, trial.answer), 40));
  };
  return fmt::format("Last right: {}; last wrong: {}.",
                     right.item.empty() ? "nothing yet" : named(right),
                     wrong.item.empty() ? "nothing yet" : named(wrong));
}

std::string NoNextLesson() {
  return "This is the last lesson: lesson and a number goes to another.";
}
std::string TutorGaveBack() { return "The device is yours again: the tutor's stroke is taken."; }
std::string Recording() { return "Recording: trace, then say record again."; }
std::string RecordedStrokeIs(double seconds) {
  return fmt::format("Recorded: {} s. Say playback to lead the learner along it.",
                     Short(seconds, 1));
}
std::string NothingRecorded() { return "Nothing recorded: the page was not touched."; }
std::string NoStrokeYet() { return "No stroke yet: say record first."; }
std::string CannotRecord() {
  return "No recording: the program's own hand is on the page. It needs a device.";
}
std::string CannotLead() { return "Nothing can lead a hand here: the device has no motors."; }

}  // namespace moontrace::say
