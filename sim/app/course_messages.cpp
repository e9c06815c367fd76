#include "sim/app/course_messages.h"

#include <fmt/core.h>

#include "lessons/course/lesson_items.h"
#include "sim/console/wording.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

namespace {

std::string Named(const Course& course, const std::vector<std::string>& items) {
  std::vector<std::string> names;
  names.reserve(items.size());
  for (const std::string& item : items) {
    names.push_back(OneLine(std::string(NameOf(course, item)), 60));
  }
  return Joined(names, ", ");
}

std::string Doing(const Step& step) {
  switch (step.kind) {
    case StepKind::kExplore:
      return "explore";
    case StepKind::kDemonstrate:
      return "be led along";
    case StepKind::kTrace:
      return "follow";
    case StepKind::kRead:
      return "read";
    case StepKind::kRecognise:
    case StepKind::kTest:
      break;
  }
  const char* asked = step.question == Question::kName   ? "name"
                      : step.question == Question::kPick ? "tell from its mate"
                                                         : "say whether it is the same as its mate";
  return step.kind == StepKind::kTest ? fmt::format("test, {}", asked) : asked;
}

}  // namespace

std::string NoCourseNamed() {
  return "course check: name a course, as in: moontrace course check learn-moon";
}
std::string TooManyCourses() {
  return "course show: one course, or a lesson of it, at a time; leave the others out";
}
std::string DeviceOnlyForCheck() { return "course show: --device is not for this; leave it out"; }

std::string UnknownProfile(std::string_view given, std::string_view nearest) {
  return fmt::format("--device: no profile '{}'; {}", OneLine(given, 40),
                     nearest.empty() ? "moontrace devices lists what there is"
                                     : fmt::format("did you mean {}?", nearest));
}

std::string CourseSound(std::string_view name, std::size_t lessons, std::size_t items,
                        std::size_t steps) {
  return fmt::format("Sound: {}, {}, {} taught, {}.", OneLine(name, 40),
                     Counted(lessons, "lesson", "lessons"), Counted(items, "item", "items"),
                     Counted(steps, "step", "steps"));
}

std::string LessonSound(std::string_view name, std::size_t items, std::size_t steps) {
  return fmt::format("Sound: lesson {}, {} taught, {}.", OneLine(name, 40),
                     Counted(items, "item", "items"), Counted(steps, "step", "steps"));
}

std::string CourseFaulty(std::string_view name, std::size_t faults) {
  return fmt::format("{} in {}:", Counted(faults, "fault", "faults"), OneLine(name, 40));
}

std::string MendFirst() {
  return "Mend these first: letters and order are looked at once every file can be read.";
}

std::string LessonUnlisted(std::string_view id) {
  return fmt::format("unreachable: the course does not list '{}'; add it to its lessons",
                     OneLine(id, 40));
}

std::string CourseOutcome(const Course& course, std::size_t items) {
  return fmt::format("{}: {}, {} taught.", OneLine(course.title, 60),
                     Counted(LessonsInOrder(course), "lesson", "lessons"),
                     Counted(items, "item", "items"));
}

std::string CourseSizes(const Course& course) {
  std::vector<std::string> sizes;
  for (const double size : course.sizes) sizes.push_back(Short(kMillimetres * size, 2));
  return fmt::format("Letters of {} mm, in script {}.", Joined(sizes, " and "),
                     OneLine(course.script, 60));
}

std::string LessonLine(const Course& course, const Lesson& lesson) {
  const std::string steps = Counted(lesson.steps.size(), "step", "steps");
  const std::string id = OneLine(lesson.id, 40), title = OneLine(lesson.title, 80);
  if (lesson.optional) return fmt::format("{}: {}. {}, beside the course.", id, title, steps);
  if (lesson.items.empty()) return fmt::format("{}: {}. {}.", id, title, steps);
  return fmt::format("{}: {}. {}. Teaches {}.", id, title, steps, Named(course, lesson.items));
}

std::string LessonNeeds(const Lesson& lesson) {
  return fmt::format("Comes after {}.", Joined(lesson.needs, " and "));
}

std::string HintLine(const Course& course, const std::string& item, std::string_view hint) {
  return fmt::format("Hint for {}: {}", OneLine(std::string(NameOf(course, item)), 60),
                     Unbroken(hint));
}

std::string StepLine(const Course& course, const Step& step, std::size_t number) {
  std::string what = step.text.empty() ? Named(course, step.items) : Unbroken(step.text);
  if (what.empty()) what = "what is new";
  if (step.own_name) what += ", and one's own name";
  std::string size;
  if (step.size) size = fmt::format(" At {} mm.", Short(kMillimetres * *step.size, 2));
  if (step.one_page) size += " On one page.";
  if (step.sure_sizes) size = fmt::format(" Until sure at {} sizes.", *step.sure_sizes);
  const bool ends = what.find_last_of(".!?") == what.size() - 1;  // a text has its own mark
  return fmt::format("Step {}, {}: {}{}{}", number, Doing(step), what, ends ? "" : ".", size);
}

std::string CourseEndsAt(double size) {
  return fmt::format(
      "Letters end at {} mm on this device: smaller ones of the course are shown at that.",
      Short(kMillimetres * size, 1));
}
std::string StepSaysHeld(std::string_view text) {
  return fmt::format("Says where the tip cannot be lifted: {}", Unbroken(text));
}
std::string StepSays(std::string_view text) { return fmt::format("Says: {}", Unbroken(text)); }

}  // namespace moontrace::say
