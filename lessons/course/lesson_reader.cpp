#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>

#include "lessons/course/course_reader.h"
#include "lessons/course/course_values.h"
#include "textures/base/nearest_word.h"
#include "textures/base/text_file.h"
#include "textures/base/toml_reader.h"

namespace moontrace {
namespace {

SourcePlace PlaceIn(const TomlTable& table, const std::string& key,
                    std::size_t element = TomlTable::kWhole) {
  const TextPlace place = table.PlaceOf(key, element);
  return {place.line, place.column};
}

/// "steps[2].items"
std::string KeyOf(std::size_t step, const char* key) {
  return fmt::format("steps[{}].{}", step, key);
}

[[noreturn]] void FailUnknownWord(const TomlTable& table, const std::string& key,
                                  const std::string& word, const std::vector<std::string>& known) {
  const std::string nearest = NearestWord(word, known);
  std::string list;
  for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
  table.Fail(key, "unknown '" + OneLine(word, 24) + "'; " +
                      (nearest.empty() ? "" : "did you mean '" + nearest + "'? ") + "one of " +
                      list);
}

void ReadKind(const TomlTable& table, Step& step) {
  const std::string kind = table.String("kind");
  if (const std::optional<StepKind> known = StepKindOf(kind)) {
    step.kind = *known;
    return;
  }
  FailUnknownWord(table, "kind", kind,
                  {"explore", "demonstrate", "trace", "recognise", "read", "test"});
}

bool Asks(StepKind kind) { return kind == StepKind::kRecognise || kind == StepKind::kTest; }
bool ShowsText(StepKind kind) { return kind == StepKind::kExplore || kind == StepKind::kRead; }

void ReadQuestion(const TomlTable& table, Step& step) {
  if (!table.Has("question")) return;
  if (!Asks(step.kind)) table.Fail("question", "only of recognise and test; leave it out");
  const std::string question = table.String("question");
  if (const std::optional<Question> known = QuestionOf(question)) {
    step.question = *known;
    return;
  }
  FailUnknownWord(table, "question", question, {"name", "pick", "same"});
}

void ReadStepText(const TomlTable& table, Step& step) {
  if (!ShowsText(step.kind)) {
    if (table.Has("text")) table.Fail("text", "only of explore and read; give items instead");
    return;
  }
  if (table.Has("items")) table.Fail("items", "not of explore and read; give a text instead");
  step.text = ReadCourseText(table, "text", kMostCourseText);
  if (IsBlank(step.text)) table.Fail("text", "empty; write what lies on the page");
}

void ReadStepItems(const TomlTable& table, const Lesson& lesson, Step& step) {
  if (ShowsText(step.kind)) return;
  if (table.Has("items")) ReadItems(table, "items", kMostItems, step.items);
  if (step.items.empty() && lesson.items.empty()) {
    table.Fail("items", "none, and the lesson teaches none; give some");
  }
}

void ReadStepSize(const TomlTable& table, Step& step) {
  if (!table.Has("size_mm")) return;
  step.size = ReadSize(table, "size_mm", table.Number("size_mm"));
}

void ReadStepSizes(const TomlTable& table, Step& step) {
  if (!table.Has("sure_sizes")) return;
  if (step.kind != StepKind::kRecognise || step.size) {
    table.Fail("sure_sizes", "only of recognise without size_mm; leave it out");
  }
  const std::int64_t sizes = table.Integer("sure_sizes");
  if (sizes < 1 || sizes > 100) table.Fail("sure_sizes", "not from 1 to 100; correct it");
  step.sure_sizes = static_cast<int>(sizes);
}

void ReadFlags(const TomlTable& table, Step& step) {
  step.own_name = table.Bool("own_name", false);
  const bool names = step.kind == StepKind::kRecognise && step.question == Question::kName;
  if (step.own_name && !names) {
    table.Fail("own_name", "only of recognise by name; leave it out");
  }
  step.one_page = table.Bool("one_page", false);
  if (step.one_page && !(ShowsText(step.kind) && step.size)) {
    table.Fail("one_page", "only of explore and read with size_mm; leave it out");
  }
}

Step ReadStep(const TomlTable& table, std::size_t index, Lesson& lesson, FaultList& faults) {
  Step step;
  const SourcePlace place = PlaceIn(table, "");
  step.line = place.line;
  step.column = place.column;
  bool has_kind = false;
  faults.Try([&] {
    ReadKind(table, step);
    has_kind = true;
  });
  for (const char* key : {"question", "say", "say_held", "items", "text", "size_mm"}) {
    if (table.Has(key)) lesson.places[KeyOf(index, key)] = PlaceIn(table, key);
  }
  if (has_kind) {  // what belongs to a step depends on its kind
    faults.Try([&] { ReadQuestion(table, step); });
    faults.Try([&] { ReadStepText(table, step); });
    faults.Try([&] { ReadStepItems(table, lesson, step); });
  }
  faults.Try([&] {
    if (table.Has("say")) step.say = ReadCourseText(table, "say", kMostCourseText);
  });
  faults.Try([&] {
    if (!table.Has("say_held")) return;
    step.say_held = ReadCourseText(table, "say_held", kMostCourseText);
    if (!table.Has("say")) table.Fail("say_held", "only beside say; add what is said elsewhere");
  });
  faults.Try([&] { ReadStepSize(table, step); });
  faults.Try([&] { ReadStepSizes(table, step); });
  if (has_kind) faults.Try([&] { ReadFlags(table, step); });
  faults.AddUnknown(table);
  for (std::size_t i = 0; i < step.items.size(); ++i) {
    lesson.places[fmt::format("{}[{}]", KeyOf(index, "items"), i)] = PlaceIn(table, "items", i);
  }
  return step;
}

void ReadList(const TomlTable& table, const std::string& key, std::vector<std::string>& list,
              Lesson& lesson) {
  if (!table.Has(key)) return;
  ReadItems(table, key, kMostItems, list);
  lesson.places[key] = PlaceIn(table, key);
  for (std::size_t i = 0; i < list.size(); ++i) {
    lesson.places[fmt::format("{}[{}]", key, i)] = PlaceIn(table, key, i);
  }
}

void ReadHints(const TomlTable& table, Lesson& lesson, FaultList& faults) {
  if (!table.Has("hints")) return;
  const TomlTable hints = table.Table("hints");
  const std::vector<std::string> items = hints.Keys();
  if (items.size() > kMostItems) {
    table.Fail("hints", fmt::format("more than {}; give fewer", kMostItems));
  }
  for (const std::string& item : items) {
    faults.Try([&] {
      lesson.hints[item] = ReadCourseText(hints, item, kMostLine);
      lesson.places["hints." + item] = PlaceIn(hints, item);
      if (std::find(lesson.items.begin(), lesson.items.end(), item) != lesson.items.end()) return;
      const std::string nearest = NearestWord(item, lesson.items);
      hints.Fail(item, "a hint for an item that is not in new; " +
                           (nearest.empty() ? "add it there" : "did you mean '" + nearest + "'?"));
    });
  }
}

void ReadSteps(const TomlTable& table, Lesson& lesson, FaultList& faults) {
  const std::vector<TomlTable> steps = table.Tables("steps");
  if (steps.size() > kMostSteps) {
    table.Fail("steps", fmt::format("more than {}; make two lessons of it", kMostSteps));
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    lesson.steps.push_back(ReadStep(steps[i], i, lesson, faults));
  }
}

}  // namespace

Lesson ParseLesson(std::string_view toml, const std::string& file, const Course& course,
                   std::vector<CourseFault>& faults) {
  Lesson lesson;
  lesson.id = std::filesystem::path(file).stem().string();
  lesson.file = file;
  lesson.title = lesson.id;
  lesson.script = course.script;
  lesson.grade = course.grade;
  FaultList list(file, faults);
  list.Try([&] {
    const TomlTable table = TomlTable::Parse(toml, file);
    list.Try([&] { lesson.title = ReadCourseLine(table, "title"); });
    list.Try([&] {
      if (!table.Has("script")) return;
      lesson.script = ReadCourseLine(table, "script");
      lesson.places["script"] = PlaceIn(table, "script");
    });
    list.Try([&] {
      if (!table.Has("grade")) return;
      lesson.grade = table.Number("grade");
      lesson.places["grade"] = PlaceIn(table, "grade");
    });
    list.Try([&] { lesson.optional = table.Bool("optional", false); });
    list.Try([&] { ReadList(table, "new", lesson.items, lesson); });
    list.Try([&] { ReadList(table, "needs", lesson.needs, lesson); });
    list.Try([&] { ReadHints(table, lesson, list); });
    list.Try([&] { ReadSteps(table, lesson, list); });
    list.AddUnknown(table);
  });
  return lesson;
}

}  // namespace moontrace
