#include "lessons/course/lesson_check.h"

#include <fmt/core.h>

#include <algorithm>

#include "lessons/course/taught_signs.h"
#include "textures/base/error.h"
#include "textures/base/nearest_word.h"
#include "textures/base/text_file.h"
#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

std::string Quoted(std::string_view text) { return fmt::format("'{}'", OneLine(text, 40)); }

bool ShowsText(StepKind kind) { return kind == StepKind::kExplore || kind == StepKind::kRead; }

SourcePlace PlaceOf(const SourcePlaces& places, const std::string& key) {
  const auto found = places.find(key);
  return found == places.end() ? SourcePlace{} : found->second;
}

/// All texts that are set in a script, so that only their characters of a large script are read.
std::string AllTexts(const Course& course, const std::string& script) {
  std::string text;
  for (const Lesson& lesson : course.lessons) {
    if (lesson.script != script) continue;
    for (const std::string& item : lesson.items) text += item + "\n";
    for (const Step& step : lesson.steps) {
      for (const std::string& item : step.items) text += item + "\n";
      text += step.text + "\n";
    }
  }
  return text;
}

}  // namespace

void CourseFaults::Add(const std::string& key, std::string what) {
  const SourcePlace place = PlaceOf(course_.places, key);
  faults_.push_back({course_.file, place.line, place.column, std::move(what)});
}

void CourseFaults::Add(const Lesson& lesson, const std::string& key, std::string what) {
  const SourcePlace place = PlaceOf(lesson.places, key);
  faults_.push_back({lesson.file, place.line, place.column, std::move(what)});
}

LessonCheck::LessonCheck(const Course& course, CourseFaults& faults)
    : course_(course), faults_(faults) {
  for (const Lesson& lesson : course.lessons) NoteTeachers(lesson);
}

const Script* LessonCheck::ScriptOf(const Lesson& lesson) {
  const auto found = scripts_.find(lesson.script);
  if (found != scripts_.end()) return found->second ? &*found->second : nullptr;
  std::optional<Script>& script = scripts_[lesson.script];
  try {
    script = FindScript(lesson.script, AllTexts(course_, lesson.script));
  } catch (const InputError& error) {
    const std::string what = OneLine(error.what(), 300);
    if (lesson.places.count("script") > 0) {
      faults_.Add(lesson, "script", what);
    } else {
      faults_.Add("script", what);
    }
  }
  return script ? &*script : nullptr;
}

bool LessonCheck::KnowsGrade(const Lesson& lesson, const Script& script) {
  if (std::count(script.grades.begin(), script.grades.end(), lesson.grade) > 0) return true;
  if (!broken_grades_.insert(lesson.id).second) return false;
  std::string known;
  for (const double grade : script.grades) {
    known += fmt::format("{}{:g}", known.empty() ? "" : ", ", grade);
  }
  faults_.Add(lesson, "grade",
              fmt::format("script {} has no grade {:g}; give one of {}", OneLine(script.name, 40),
                          lesson.grade, known));
  return false;
}

void LessonCheck::NoteTeachers(const Lesson& lesson) {
  const Script* script = lesson.script == course_.script ? ScriptOf(lesson) : nullptr;
  if (script == nullptr || !KnowsGrade(lesson, *script)) return;
  for (const std::string& item : lesson.items) {
    const SignUse use = SignsOf(item, *script, lesson.grade, nullptr);
    if (!TeachesSigns(item, use)) continue;
    for (const std::string& sign : use.signs) teachers_.emplace(sign, lesson.id);
  }
}

void LessonCheck::Check(const Lesson& lesson, bool reached) {
  CheckTwice(lesson);
  CheckShown(lesson);
  const Script* script = ScriptOf(lesson);
  const bool own = lesson.script == course_.script;
  const bool sets = script != nullptr && KnowsGrade(lesson, *script);
  for (const std::string& item : sets&& own ? lesson.items : std::vector<std::string>{}) {
    const SignUse use = SignsOf(item, *script, lesson.grade, nullptr);
    if (TeachesSigns(item, use)) taught_.insert(use.signs.begin(), use.signs.end());
  }
  for (std::size_t i = 0; sets && i < lesson.items.size(); ++i) {
    CheckText(lesson, *script, fmt::format("new[{}]", i), lesson.items[i], own && reached);
  }
  for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
    const Step& step = lesson.steps[k];
    const std::string key = fmt::format("steps[{}].", k);
    if (sets && !step.text.empty()) {
      CheckText(lesson, *script, key + "text", step.text, own && reached);
    }
    for (std::size_t i = 0; sets && i < step.items.size(); ++i) {
      CheckText(lesson, *script, fmt::format("{}items[{}]", key, i), step.items[i], own && reached);
    }
    if (step.question == Question::kPick) {
      CheckPick(lesson, step, k, sets && own && reached ? script : nullptr);
    }
  }
}

void LessonCheck::CheckTwice(const Lesson& lesson) {
  for (std::size_t i = 0; i < lesson.items.size(); ++i) {
    const auto added = taught_in_.emplace(LowerCase(lesson.items[i]), lesson.id);
    if (added.second) continue;
    faults_.Add(lesson, fmt::format("new[{}]", i),
                fmt::format("{} is taught twice, first in {}; leave it out here",
                            Quoted(lesson.items[i]), OneLine(added.first->second, 40)));
  }
}

void LessonCheck::CheckShown(const Lesson& lesson) {
  std::set<std::string> shown;
  for (const Step& step : lesson.steps) {
    if (ShowsText(step.kind)) continue;
    if (step.items.empty()) return;  // all of them
    shown.insert(step.items.begin(), step.items.end());
  }
  for (std::size_t i = 0; i < lesson.items.size(); ++i) {
    if (lesson.steps.empty() || shown.count(lesson.items[i]) > 0) continue;
    faults_.Add(lesson, fmt::format("new[{}]", i),
                fmt::format("{} is taught but no step shows it; add it to a step's items",
                            Quoted(lesson.items[i])));
  }
}

void LessonCheck::CheckText(const Lesson& lesson, const Script& script, const std::string& key,
                            std::string_view text, bool must_be_taught) {
  const SignUse use = SignsOf(text, script, lesson.grade, must_be_taught ? &taught_ : nullptr);
  for (const std::string& character : use.missing) {
    faults_.Add(lesson, key,
                fmt::format("{} has no form in script {}; write it otherwise", Quoted(character),
                            OneLine(script.name, 40)));
  }
  for (const std::string& character : use.untaught) {
    const SignUse alone = SignsOf(character, script, lesson.grade, nullptr);
    const auto sign =
        std::find_if(alone.signs.begin(), alone.signs.end(),
                     [this](const std::string& name) { return taught_.count(name) == 0; });
    const auto teacher = sign == alone.signs.end() ? teachers_.end() : teachers_.find(*sign);
    faults_.Add(lesson, key,
                teacher == teachers_.end()
                    ? fmt::format("{} is used, and no lesson teaches it; add it to the new of one",
                                  Quoted(character))
                    : fmt::format("{} is used before it is taught, in {}; do without it here",
                                  Quoted(character), OneLine(teacher->second, 40)));
  }
}

void LessonCheck::CheckPick(const Lesson& lesson, const Step& step, std::size_t index,
                            const Script* script) {
  const bool own_items = !step.items.empty();
  const std::vector<std::string>& items = own_items ? step.items : lesson.items;
  if (std::set<std::string>(items.begin(), items.end()).size() > 1) return;  // against each other
  const std::string list = own_items ? fmt::format("steps[{}].items", index) : "new";
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto mate = course_.mates.find(items[i]);
    const std::string key = fmt::format("{}[{}]", list, i);
    if (mate == course_.mates.end()) {
      faults_.Add(lesson, key,
                  fmt::format("{} has no mate to be asked against; name one under mates in the "
                              "course",
                              Quoted(items[i])));
      continue;
    }
    if (script == nullptr) continue;
    const SignUse use = SignsOf(mate->second, *script, lesson.grade, &taught_);
    if (use.missing.empty() && use.untaught.empty()) continue;
    faults_.Add(lesson, key,
                fmt::format("the mate of {} is {}, which is not taught by now; ask it later",
                            Quoted(items[i]), Quoted(mate->second)));
  }
}

}  // namespace moontrace
