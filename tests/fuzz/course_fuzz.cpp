// Any bytes as a course's file, and as a lesson's, are read or refused by lines with a place in
// them; what was read can be checked. Bounded by the reader's limits.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/course/course_reader.h"
#include "lessons/course/course_values.h"
#include "textures/base/error.h"

namespace {

using moontrace::CourseFault;

void MustBeLines(const std::vector<CourseFault>& faults) {
  for (const CourseFault& fault : faults) {
    if (fault.what.empty() || LineOf(fault).find('\n') != std::string::npos) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace moontrace;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  std::vector<CourseFault> faults;
  std::vector<std::string> ids;
  Course course = ParseCourse(text, "course.toml", ids, faults);
  if (ids.size() > kMostLessons) std::abort();
  const Lesson lesson = ParseLesson(text, "lesson.toml", course, faults);
  if (lesson.steps.size() > kMostSteps || lesson.items.size() > kMostItems) std::abort();
  MustBeLines(faults);
  // Not a path of this machine: the fuzzer must open no files.
  course.script = "moon";
  course.lessons = {lesson, lesson};
  course.lessons[0].id = "first";
  for (Lesson& each : course.lessons) each.script = "moon";
  MustBeLines(CheckCourse(course, 0.01));
  return 0;
}
