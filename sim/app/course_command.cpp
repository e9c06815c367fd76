#include "sim/app/commands.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>

#include "devices/catalogue/catalogue.h"
#include "devices/core/smallest_letter.h"
#include "lessons/course/course_reader.h"
#include "lessons/course/lesson_items.h"
#include "sim/app/course_messages.h"
#include "sim/learn/learn_messages.h"
#include "sim/setup/help.h"
#include "sim/setup/setup_messages.h"
#include "sim/setup/typeset_report.h"
#include "textures/base/error.h"
#include "textures/base/nearest_word.h"
#include "textures/base/units.h"

namespace moontrace {

namespace {

namespace fs = std::filesystem;

constexpr const char* kShipped = "learn-moon";
constexpr const char* kCourseFile = "course.toml";

/// What a path means: a course, and of it one lesson's file alone if that was named.
struct Target {
  std::string name;    ///< as given
  std::string course;  ///< for ReadCourse
  std::string lesson;  ///< its file; empty = all of the course
};

/// A TOML file beside a course's file is one of its lessons.
Target TargetOf(const std::string& given) {
  if (given.empty()) throw UsageError(say::ValueEmpty("course"));
  Target target{given, given, ""};
  const fs::path path(given);
  std::error_code ignored;
  const fs::path beside = path.parent_path() / kCourseFile;
  if (path.extension() != ".toml" || path.filename() == kCourseFile ||
      !fs::is_regular_file(path, ignored) || !fs::is_regular_file(beside, ignored)) {
    return target;
  }
  target.course = beside.string();
  target.lesson = given;
  return target;
}

std::size_t ItemCount(const Course& course) {
  std::size_t count = 0;
  for (const Lesson& lesson : course.lessons) count += lesson.items.size();
  return count;
}

std::size_t StepCount(const Course& course) {
  std::size_t count = 0;
  for (const Lesson& lesson : course.lessons) count += lesson.steps.size();
  return count;
}

const Lesson* LessonOf(const Course& course, const std::string& file) {
  const auto found = std::find_if(course.lessons.begin(), course.lessons.end(),
                                  [&file](const Lesson& lesson) { return lesson.file == file; });
  return found == course.lessons.end() ? nullptr : &*found;
}

/// What was found of one target.
struct Checked {
  Target target;
  Course course;
  std::vector<CourseFault> faults;
  bool read = true;    ///< all files could be read, so that what is taught when was looked at
  double ends_at = 0;  ///< letters end at this size on the device asked for [m]; 0: at the course's
};

Checked CheckTarget(const std::string& given, double smallest) {
  Checked checked;
  checked.target = TargetOf(given);
  CourseReading reading = ReadCourse(checked.target.course);
  checked.read = reading.faults.empty();
  checked.faults = checked.read ? CheckCourse(reading.course, smallest) : std::move(reading.faults);
  for (const std::string& file : reading.unlisted) {
    checked.faults.push_back({file, 0, 0, say::LessonUnlisted(fs::path(file).stem().string())});
  }
  std::ranges::move(FaultsOfUnlisted(reading), std::back_inserter(checked.faults));
  const std::string& lesson = checked.target.lesson;
  const auto elsewhere = [&lesson](const CourseFault& fault) { return fault.file != lesson; };
  // Where other files cannot be read, nothing is known of this one: then they are what to mend.
  if (!lesson.empty() &&
      (checked.read || !std::all_of(checked.faults.begin(), checked.faults.end(), elsewhere))) {
    std::erase_if(checked.faults, elsewhere);
  }
  checked.course = std::move(reading.course);
  Course ended = checked.course;
  if (checked.faults.empty() && EndSizesAt(ended, smallest)) checked.ends_at = ended.sizes.back();
  return checked;
}

double SmallestOf(const std::string& device) {
  if (device.empty()) return 0;
  std::vector<std::string> names;
  for (const DeviceProfile& profile : LoadProfiles(ProfilesFolder())) {
    if (profile.name == device) return SmallestLetter(profile);
    names.push_back(profile.name);
  }
  throw UsageError(say::UnknownProfile(device, NearestWord(device, names)));
}

Json FaultJson(const CourseFault& fault) {
  Json json{{"file", fault.file}, {"what", fault.what}};
  json["line"] = fault.line > 0 ? Json(fault.line) : Json(nullptr);
  json["column"] = fault.line > 0 ? Json(fault.column) : Json(nullptr);
  return json;
}

Json CheckedJson(const Checked& checked) {
  Json faults = Json::array();
  for (const CourseFault& fault : checked.faults) faults.push_back(FaultJson(fault));
  Json json{{"name", checked.target.name},        {"sound", checked.faults.empty()},
            {"all_read", checked.read},           {"lessons", checked.course.lessons.size()},
            {"items", ItemCount(checked.course)}, {"steps", StepCount(checked.course)},
            {"faults", std::move(faults)}};
  if (checked.ends_at > 0) json["ends_at_mm"] = kMillimetres * checked.ends_at;
  return json;
}

void SayChecked(const Checked& checked, Console& console) {
  const std::string& name = checked.target.name;
  const Lesson* lesson = LessonOf(checked.course, checked.target.lesson);
  if (!checked.faults.empty()) {
    console.Result(say::CourseFaulty(name, checked.faults.size()));
    // One line each, however long, so that an editor finds the place.
    for (const CourseFault& fault : checked.faults) console.Path(LineOf(fault));
    if (!checked.read) console.Result(say::MendFirst());
  } else if (lesson != nullptr) {
    console.Result(say::LessonSound(lesson->id, lesson->items.size(), lesson->steps.size()));
  } else {
    console.Result(say::CourseSound(checked.course.id, checked.course.lessons.size(),
                                    ItemCount(checked.course), StepCount(checked.course)));
  }
  if (checked.ends_at > 0) console.Result(say::CourseEndsAt(checked.ends_at));
}

int Check(const CourseOptions& options, Console& console) {
  const double smallest = SmallestOf(options.device);
  bool sound = true;
  Json list = Json::array();
  for (std::size_t i = 1; i < options.words.size(); ++i) {
    console.CheckStop();
    const Checked checked = CheckTarget(options.words[i], smallest);
    sound = sound && checked.faults.empty();
    if (options.output.json) {
      list.push_back(CheckedJson(checked));
    } else {
      SayChecked(checked, console);
    }
  }
  if (options.output.json) {
    Json json{{"sound", sound}, {"courses", std::move(list)}};
    if (!options.device.empty()) json["smallest_mm"] = OrNull(kMillimetres * smallest);
    console.Json(Dump(json));
  }
  return sound ? exit_code::kGood : exit_code::kInput;
}

Json StepJson(const Step& step) {
  Json json{{"kind", std::string(NameOf(step.kind))}, {"say", step.say}};
  if (!step.say_held.empty()) json["say_held"] = step.say_held;
  if (step.kind == StepKind::kRecognise || step.kind == StepKind::kTest) {
    json["question"] = std::string(NameOf(step.question));
  }
  if (!step.items.empty()) json["items"] = step.items;
  if (!step.text.empty()) json["text"] = step.text;
  if (step.own_name) json["own_name"] = true;
  if (step.one_page) json["one_page"] = true;
  if (step.size) json["size_mm"] = kMillimetres * *step.size;
  return json;
}

Json LessonJson(const Lesson& lesson) {
  Json steps = Json::array();
  for (const Step& step : lesson.steps) steps.push_back(StepJson(step));
  return Json{{"id", lesson.id},       {"title", lesson.title}, {"script", lesson.script},
              {"grade", lesson.grade}, {"new", lesson.items},   {"needs", lesson.needs},
              {"hints", lesson.hints}, {"steps", steps}};
}

Json CourseJson(const Course& course, const Lesson* only) {
  Json lessons = Json::array();
  for (const Lesson& lesson : course.lessons) {
    if (only == nullptr || only == &lesson) lessons.push_back(LessonJson(lesson));
  }
  std::vector<double> sizes;
  for (const double size : course.sizes) sizes.push_back(kMillimetres * size);
  return Json{{"id", course.id},         {"title", course.title}, {"language", course.language},
              {"script", course.script}, {"sizes_mm", sizes},     {"names", course.names},
              {"mates", course.mates},   {"lessons", lessons}};
}

void SayLesson(const Course& course, const Lesson& lesson, Console& console) {
  console.Result(say::LessonLine(course, lesson));
  if (!lesson.needs.empty()) console.Result(say::LessonNeeds(lesson));
  for (const std::string& item : lesson.items) {
    const auto hint = lesson.hints.find(item);
    if (hint != lesson.hints.end()) console.Result(say::HintLine(course, item, hint->second));
  }
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    console.Result(say::StepLine(course, lesson.steps[i], i + 1));
    const Step& step = lesson.steps[i];
    if (!step.say.empty()) console.Result(say::StepSays(step.say));
    if (!step.say_held.empty()) console.Result(say::StepSaysHeld(step.say_held));
  }
}

/// Whether a word can name a course, rather than a lesson of the shipped one.
bool IsCourse(const std::string& given) {
  const std::vector<std::string> shipped = ShippedCourses();
  const fs::path path(given);
  std::error_code ignored;
  return given.empty() || given.find('/') != std::string::npos || path.extension() == ".toml" ||
         fs::is_directory(path, ignored) || !NearestWord(given, shipped).empty() ||
         std::find(shipped.begin(), shipped.end(), given) != shipped.end();
}

/// A lesson of a course by what people call it. Throws UsageError for none.
const Lesson& LessonCalled(const Course& course, const std::string& given) {
  if (const auto index = LessonNamed(course, given)) return course.lessons[*index];
  std::vector<std::string> ids;
  for (const Lesson& lesson : course.lessons) ids.push_back(lesson.id);
  throw UsageError(say::NoSuchLesson(given, NearestWord(given, ids)));
}

int Show(const CourseOptions& options, Console& console) {
  std::vector<std::string> words(options.words.begin() + 1, options.words.end());
  if (words.empty() || !IsCourse(words.front())) words.insert(words.begin(), kShipped);
  if (words.size() > 2) throw UsageError(say::TooManyCourses());
  const Target target = TargetOf(words.front());
  const Course course = LoadCourse(target.course);
  const Lesson* lesson = LessonOf(course, target.lesson);
  if (lesson == nullptr && !target.lesson.empty()) {
    throw InputError(target.lesson + ": " +
                     say::LessonUnlisted(fs::path(target.lesson).stem().string()));
  }
  if (words.size() > 1) lesson = &LessonCalled(course, words[1]);
  if (options.output.json) {
    console.Json(Dump(CourseJson(course, lesson)));
    return exit_code::kGood;
  }
  if (lesson != nullptr) {
    SayLesson(course, *lesson, console);
    return exit_code::kGood;
  }
  console.Result(say::CourseOutcome(course, ItemCount(course)));
  console.Result(say::CourseSizes(course));
  for (const Lesson& each : course.lessons) console.Result(say::LessonLine(course, each));
  return exit_code::kGood;
}

void CheckUse(const CourseOptions& options) {
  const std::vector<std::string>& words = options.words;
  const std::string action = words.empty() ? "" : words.front();
  if (action != "check" && action != "show") {
    throw UsageError(say::NotAnAction("course", action, NearestWord(action, {"check", "show"}),
                                      "check or show"));
  }
  if (action == "check" && words.size() < 2) throw UsageError(say::NoCourseNamed());
  if (action == "show" && !options.device.empty()) throw UsageError(say::DeviceOnlyForCheck());
}

}  // namespace

void AddOptions(CLI::App& app, CourseOptions& options) {
  AddWords(app, options.words, say::help::kCourseWords);
  AddPath(app, "--device", "NAME", options.device, say::help::kCourseDevice);
  AddOptions(app, options.output);
}

int Run(const CourseOptions& options, Console& console) {
  CheckUse(options);
  return options.words.front() == "check" ? Check(options, console) : Show(options, console);
}

}  // namespace moontrace
