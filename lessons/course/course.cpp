#include "lessons/course/course.h"

#include <fmt/core.h>

#include <array>
#include <utility>

namespace moontrace {
namespace {

constexpr std::array<std::pair<StepKind, std::string_view>, 6> kKinds{
    {{StepKind::kExplore, "explore"},
     {StepKind::kDemonstrate, "demonstrate"},
     {StepKind::kTrace, "trace"},
     {StepKind::kRecognise, "recognise"},
     {StepKind::kRead, "read"},
     {StepKind::kTest, "test"}}};

constexpr std::array<std::pair<Question, std::string_view>, 3> kQuestions{
    {{Question::kName, "name"}, {Question::kPick, "pick"}, {Question::kSame, "same"}}};

template <class Value, std::size_t kSize>
std::string_view NameIn(const std::array<std::pair<Value, std::string_view>, kSize>& all,
                        Value value) {
  for (const auto& entry : all) {
    if (entry.first == value) return entry.second;
  }
  return {};
}

template <class Value, std::size_t kSize>
std::optional<Value> ValueIn(const std::array<std::pair<Value, std::string_view>, kSize>& all,
                             std::string_view name) {
  for (const auto& entry : all) {
    if (entry.second == name) return entry.first;
  }
  return std::nullopt;
}

}  // namespace

std::string_view NameOf(StepKind kind) { return NameIn(kKinds, kind); }
std::optional<StepKind> StepKindOf(std::string_view name) { return ValueIn(kKinds, name); }
std::string_view NameOf(Question question) { return NameIn(kQuestions, question); }
std::optional<Question> QuestionOf(std::string_view name) { return ValueIn(kQuestions, name); }

std::string_view NameOf(const Course& course, std::string_view item) {
  const auto found = course.names.find(std::string(item));
  return found == course.names.end() ? item : std::string_view(found->second);
}

std::string LineOf(const CourseFault& fault) {
  if (fault.line == 0) return fmt::format("{}: {}", fault.file, fault.what);
  return fmt::format("{}:{}:{}: {}", fault.file, fault.line, fault.column, fault.what);
}

}  // namespace moontrace
