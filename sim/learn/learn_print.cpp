#include "sim/learn/learn_print.h"

#include <string>
#include <vector>

#include "lessons/course/lesson_items.h"
#include "sim/learn/learn_messages.h"
#include "sim/picture/moon_marks.h"
#include "sim/picture/picture_file.h"
#include "sim/picture/picture_messages.h"
#include "textures/base/error.h"
#include "textures/base/nearest_word.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

namespace {

const Lesson& LessonToPrint(const Course& course, const std::string& name) {
  if (course.lessons.empty()) throw InputError(say::NothingToPrint(course.id));
  if (name.empty()) return course.lessons.front();
  if (const auto index = LessonNamed(course, name)) return course.lessons[*index];
  std::vector<std::string> ids;
  for (const Lesson& lesson : course.lessons) ids.push_back(lesson.id);
  throw UsageError(say::NoSuchLesson(name, NearestWord(name, ids)));
}

/// What is felt in a lesson, one line an item or text.
std::string TextOfLesson(const Lesson& lesson) {
  std::string text;
  const auto add = [&text](const std::string& line) {
    if (!line.empty()) text += line + '\n';
  };
  for (const std::string& item : lesson.items) add(item);
  for (const Step& step : lesson.steps) {
    add(step.text);
    for (const std::string& item : step.items) {
      if (text.find(item + '\n') == std::string::npos) add(item);
    }
  }
  return text;
}

/// Swell paper rises where it is black: strokes are, and nothing else is drawn.
Drawing SwellPage(const Typeset& set, const TextPage& sheet, const Script& script,
                  const std::string& title) {
  constexpr double kMillimetres = 1e3;
  Drawing drawing;
  drawing.width = kMillimetres * set.page.width;
  drawing.height = kMillimetres * set.page.height;
  drawing.title = title;
  drawing.description = say::PagePictureWords(sheet.glyphs.size(), sheet.lines, set.style);
  drawing.marks = MoonMarks(sheet, script, set.style, {0, 0}, Color{0, 0, 0});
  return drawing;
}

}  // namespace

int PrintLesson(const LearnOptions& options, const Course& course, Console& console) {
  CheckPicturePath(options.print);
  const Lesson& lesson = LessonToPrint(course, options.lesson);
  const std::string text = TextOfLesson(lesson);
  if (text.empty()) throw InputError(say::NothingToPrint(lesson.id));
  StyleOptions style_options;
  style_options.script = lesson.script.empty() ? course.script : lesson.script;
  style_options.size = options.size.value_or(course.sizes.empty() ? 0.02 : course.sizes.front());
  if (lesson.grade != 1) style_options.grade = lesson.grade;
  const LayoutOptions layout;
  Script script = ScriptOf(style_options, nullptr, text);
  const TypeStyle style = StyleOf(style_options, layout, script, nullptr);
  const Typeset set = SetText(text, script, style, PageOf(layout));
  PagePictures pictures(options.print, set.pages.size());
  for (const TextPage& page : set.pages) {
    console.CheckStop();
    pictures.Add(SwellPage(set, page, script, lesson.title));
  }
  const std::vector<std::string> files = pictures.Finish();
  console.Result(say::Printed(lesson.title, set.pages.size(), style.size));
  for (const std::string& file : files) console.Path(file);
  return exit_code::kGood;
}

}  // namespace moontrace
