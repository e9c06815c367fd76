#include "sim/learn/learn_simulated_messages.h"

#include <fmt/core.h>

namespace moontrace::say {

namespace {

std::string Counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace

std::string SimulatedBegins(std::string_view course, std::size_t lessons) {
  return fmt::format("A simulated learner begins {}, {}.", course,
                     Counted(lessons, "lesson", "lessons"));
}

std::string SimulatedGoesOn(std::string_view learner, std::size_t trials) {
  return fmt::format("{} goes on after {}.", learner, Counted(trials, "trial", "trials"));
}

std::string SimulatedLesson(std::string_view title, int day, std::size_t trials) {
  return fmt::format("Lesson done: {}. Day {}, {} so far.", title, day,
                     Counted(trials, "trial", "trials"));
}

std::string SimulatedSizes(const std::vector<double>& sizes) {
  std::string list;
  for (const double size : sizes) {
    list += fmt::format("{}{:.4g}", list.empty() ? "" : ", ", 1e3 * size);
  }
  return fmt::format("Signs were sure at {} mm.", list);
}

std::string SimulatedDone(int days, std::size_t trials, double hours) {
  return fmt::format("Course done, in {} and {}, {:.1f} hours of the hand's work.",
                     Counted(static_cast<std::size_t>(days), "day", "days"),
                     Counted(trials, "trial", "trials"), hours);
}

std::string SimulatedEnded(int days, std::string_view lesson) {
  return fmt::format("Course not done after {}: it is at {}.",
                     Counted(static_cast<std::size_t>(days), "day", "days"), lesson);
}

std::string SimulatedMastered(std::size_t mastered, std::size_t items, double size) {
  return fmt::format("Mastered at {:.4g} mm: {} of {} worked on.", 1e3 * size, mastered,
                     Counted(items, "sign or word", "signs and words"));
}

std::string SimulatedStuck(std::string_view lesson, std::string_view item) {
  return fmt::format("stuck in lesson {} at {}: it never became sure", lesson,
                     item.empty() ? "no sign" : item);
}

std::string SimulatedProves() {
  return "A simulated learner proves the software, not the pedagogy.";
}

std::string NotSimulated(std::string_view learner) {
  return fmt::format("{} is a person in these records: choose another --learner name", learner);
}

}  // namespace moontrace::say
