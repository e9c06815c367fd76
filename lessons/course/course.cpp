#include "lessons/course/course.h"

#include <fmt/core.h>

#include "textures/base/enum_names.h"

namespace moontrace {
namespace {

constexpr std::string_view NameOfKind(StepKind kind) {
  switch (kind) {
    case StepKind::kExplore:
      return "explore";
    case StepKind::kDemonstrate:
      return "demonstrate";
    case StepKind::kTrace:
      return "trace";
    case StepKind::kRecognise:
      return "recognise";
    case StepKind::kRead:
      return "read";
    case StepKind::kTest:
      return "test";
  }
  return {};
}

constexpr std::string_view NameOfQuestion(Question question) {
  switch (question) {
    case Question::kName:
      return "name";
    case Question::kPick:
      return "pick";
    case Question::kSame:
      return "same";
  }
  return {};
}

}  // namespace

std::string_view NameOf(StepKind kind) { return NameOfKind(kind); }
std::optional<StepKind> StepKindOf(std::string_view name) { return ValueNamed(name, &NameOfKind); }
std::string_view NameOf(Question question) { return NameOfQuestion(question); }
std::optional<Question> QuestionOf(std::string_view name) {
  return ValueNamed(name, &NameOfQuestion);
}

std::string_view NameOf(const Course& course, std::string_view item) {
  const auto found = course.names.find(std::string(item));
  return found == course.names.end() ? item : std::string_view(found->second);
}

std::string LineOf(const CourseFault& fault) {
  if (fault.line == 0) return fmt::format("{}: {}", fault.file, fault.what);
  return fmt::format("{}:{}:{}: {}", fault.file, fault.line, fault.column, fault.what);
}

}  // namespace moontrace
