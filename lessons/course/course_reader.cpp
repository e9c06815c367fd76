#include "lessons/course/course_reader.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "lessons/course/course_values.h"
#include "lessons/course/spelling.h"
#include "textures/base/error.h"
#include "textures/base/nearest_word.h"
#include "textures/base/resources.h"
#include "textures/base/text_file.h"
#include "textures/base/toml_reader.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t{1} << 20;  // as the TOML reader's
constexpr const char* kCourseFile = "course.toml";
constexpr const char* kShipped = "lessons/courses";
constexpr double kMinute = 60;  // [s]

double From(const TomlTable& table, const std::string& key, double otherwise, double low,
            double high) {
  const double number = table.Number(key, otherwise);
  if (!(number >= low && number <= high)) {
    table.Fail(key, fmt::format("not from {:g} to {:g}; correct it", low, high));
  }
  return number;
}

int Count(const TomlTable& table, const std::string& key, int otherwise, int low, int high) {
  const std::int64_t number = table.Integer(key, otherwise);
  if (number < low || number > high) {
    table.Fail(key, fmt::format("not from {} to {}; correct it", low, high));
  }
  return static_cast<int>(number);
}

void NotePlaces(const TomlTable& table, const std::string& key, std::size_t count, Course& course) {
  for (std::size_t i = 0; i < count; ++i) {
    const TextPlace place = table.PlaceOf(key, i);
    course.places[fmt::format("{}[{}]", key, i)] = {place.line, place.column};
  }
}

void ReadSizes(const TomlTable& table, Course& course) {
  for (const double size_mm : table.Numbers("sizes_mm")) {
    const double size = ReadSize(table, "sizes_mm", size_mm);
    if (!course.sizes.empty() && !(size < course.sizes.back())) {
      table.Fail("sizes_mm", "not descending; order them from the largest to the smallest");
    }
    course.sizes.push_back(size);
  }
  if (course.sizes.empty()) table.Fail("sizes_mm", "empty; give one size at least");
  NotePlaces(table, "sizes_mm", course.sizes.size(), course);
}

void ReadMastery(const TomlTable& table, MasteryRule& rule, FaultList& faults) {
  if (!table.Has("mastery")) return;
  const TomlTable mastery = table.Table("mastery");
  faults.Try([&] { rule.attempts = Count(mastery, "attempts", rule.attempts, 1, 100); });
  faults.Try([&] { rule.traces = Count(mastery, "traces", rule.traces, 1, 100); });
  faults.Try([&] { rule.recognised = From(mastery, "recognised", rule.recognised, 0, 1); });
  faults.Try([&] { rule.sure_sizes = Count(mastery, "sure_sizes", rule.sure_sizes, 1, 100); });
  faults.Try([&] { rule.words = Count(mastery, "words", rule.words, 1, 100); });
  faults.Try([&] { rule.coverage = From(mastery, "coverage", rule.coverage, 0, 1); });
  faults.Try([&] { rule.error_widths = From(mastery, "error_widths", rule.error_widths, 0, 10); });
  faults.Try([&] { rule.failures = Count(mastery, "failures", rule.failures, 1, 100); });
  faults.Try([&] { rule.target = From(mastery, "target", rule.target, 0, 1); });
  faults.Try([&] { rule.known = From(mastery, "known", rule.known, 0, 0.5); });
  faults.Try([&] { rule.reviews = Count(mastery, "reviews", rule.reviews, 0, 1000); });
  faults.Try([&] { rule.quick = From(mastery, "quick_s", rule.quick, 0, 3600); });
  faults.Try([&] { rule.slow = From(mastery, "slow_s", rule.slow, 0, 3600); });
  faults.AddUnknown(mastery);
}

void ReadFade(const TomlTable& table, FadeSettings& settings, FaultList& faults) {
  if (!table.Has("fade")) return;
  const TomlTable fade = table.Table("fade");
  faults.Try([&] {
    const std::vector<std::string> known{"manual", "linear", "gate", "as-needed"};
    const std::string rule = fade.String("rule", settings.rule);
    if (std::find(known.begin(), known.end(), rule) == known.end()) {
      const std::string nearest = NearestWord(rule, known);
      fade.Fail("rule", "unknown '" + OneLine(rule, 24) + "'; " +
                            (nearest.empty() ? "" : "did you mean '" + nearest + "'? ") +
                            "one of manual, linear, gate, as-needed");
    }
    settings.rule = rule;
  });
  faults.Try([&] { settings.start = Count(fade, "start", settings.start, 0, 10); });
  faults.Try(
      [&] { settings.probe_every = Count(fade, "probe_every", settings.probe_every, 2, 100); });
  faults.AddUnknown(fade);
}

/// A table of words for items: names, mates.
void ReadWords(const TomlTable& table, const std::string& key,
               std::map<std::string, std::string>& words, Course& course, FaultList& faults) {
  if (!table.Has(key)) return;
  const TomlTable inner = table.Table(key);
  const std::vector<std::string> items = inner.Keys();
  if (items.size() > kMostEntries) {
    table.Fail(key, fmt::format("more than {}; give fewer", kMostEntries));
  }
  for (const std::string& item : items) {
    faults.Try([&] { words[item] = ReadCourseLine(inner, item); });
    const TextPlace place = inner.PlaceOf(item);
    course.places[fmt::format("{}.{}", key, item)] = {place.line, place.column};
  }
}

std::vector<std::string> ReadLessonIds(const TomlTable& table, Course& course) {
  std::vector<std::string> ids;
  ReadItems(table, "lessons", kMostLessons, ids);
  if (ids.empty()) table.Fail("lessons", "empty; name one lesson at least");
  NotePlaces(table, "lessons", ids.size(), course);
  return ids;
}

std::string IdOf(const std::string& file) {
  const fs::path path(file);
  if (path.filename() != kCourseFile) return path.stem().string();
  std::error_code ignored;
  return fs::absolute(path, ignored).parent_path().filename().string();
}

/// Stems of the lessons that lie beside the course's file, sorted.
std::vector<std::string> LessonsBeside(const fs::path& course_file) {
  std::vector<std::string> stems;
  std::error_code error;
  fs::path folder = course_file.parent_path();
  if (folder.empty()) folder = ".";
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (at->path().extension() != ".toml" || at->path().filename() == course_file.filename()) {
      continue;
    }
    stems.push_back(at->path().stem().string());
    if (stems.size() > 2 * kMostLessons) break;
  }
  std::sort(stems.begin(), stems.end());
  return stems;
}

class LessonFiles {
 public:
  LessonFiles(std::string course_file, CourseReading& reading)
      : file_(std::move(course_file)), reading_(reading), beside_(LessonsBeside(file_)) {}

  void Read(const std::vector<std::string>& ids) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (!listed_.insert(ids[i]).second) {
        Fault(i, "lesson '" + OneLine(ids[i], 40) + "' is listed twice; leave one out");
      } else if (std::find(beside_.begin(), beside_.end(), ids[i]) == beside_.end()) {
        const std::string nearest = NearestWord(ids[i], beside_);
        Fault(i, "no lesson '" + OneLine(ids[i], 40) + "' beside the course; " +
                     (nearest.empty() ? "write " + OneLine(ids[i], 40) + ".toml"
                                      : "did you mean '" + OneLine(nearest, 40) + "'?"));
      } else {
        ReadOne(i, (fs::path(file_).parent_path() / (ids[i] + ".toml")).string());
      }
    }
    for (const std::string& stem : beside_) {
      if (listed_.count(stem) != 0) continue;
      reading_.unlisted.push_back((fs::path(file_).parent_path() / (stem + ".toml")).string());
    }
  }

 private:
  void Fault(std::size_t index, const std::string& what) {
    const SourcePlace place = reading_.course.places[fmt::format("lessons[{}]", index)];
    reading_.faults.push_back({file_, place.line, place.column, what});
  }
  void ReadOne(std::size_t index, const std::string& path) {
    try {
      const std::string toml = ReadTextFile(path, kMostBytes);
      reading_.course.lessons.push_back(ParseLesson(toml, path, reading_.course, reading_.faults));
    } catch (const InputError& error) {
      Fault(index, error.what());
    }
  }

  std::string file_;
  CourseReading& reading_;
  std::vector<std::string> beside_;
  std::set<std::string> listed_;
};

}  // namespace

std::vector<std::string> ShippedCourses() {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(ResourcePath(kShipped), error), end; !error && at != end;
       at.increment(error)) {
    if (fs::exists(at->path() / kCourseFile)) names.push_back(at->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string CoursePath(const std::string& name_or_path) {
  const fs::path path(name_or_path);
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return (path / kCourseFile).string();
  if (name_or_path.find('/') != std::string::npos || path.extension() == ".toml" ||
      name_or_path.empty()) {
    return name_or_path;
  }
  const std::vector<std::string> names = ShippedCourses();
  if (std::find(names.begin(), names.end(), name_or_path) != names.end()) {
    return (fs::path(ResourcePath(kShipped)) / name_or_path / kCourseFile).string();
  }
  std::string known;
  for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
  const std::string nearest = NearestWord(name_or_path, names);
  throw InputError("unknown course '" + OneLine(name_or_path, 40) + "'; " +
                   (nearest.empty() ? "there is " + known + "; a path needs a slash"
                                    : "did you mean " + nearest + "?"));
}

Course ParseCourse(std::string_view toml, const std::string& file,
                   std::vector<std::string>& lessons, std::vector<CourseFault>& faults) {
  Course course;
  course.id = IdOf(file);
  course.file = file;
  course.title = course.id;
  FaultList list(file, faults);
  list.Try([&] {
    const TomlTable table = TomlTable::Parse(toml, file);
    list.Try([&] { course.title = ReadCourseLine(table, "title"); });
    list.Try([&] { course.language = ReadCourseLine(table, "language"); });
    list.Try([&] {
      course.script = ReadCourseLine(table, "script");
      const TextPlace place = table.PlaceOf("script");
      course.places["script"] = {place.line, place.column};
    });
    list.Try([&] { course.grade = table.Number("grade", course.grade); });
    list.Try([&] { ReadSizes(table, course); });
    list.Try([&] {
      course.break_after =
          kMinute * From(table, "break_after_min", course.break_after / kMinute, 1, 1440);
    });
    list.Try([&] { ReadMastery(table, course.mastery, list); });
    list.Try([&] { ReadFade(table, course.fade, list); });
    list.Try([&] { ReadWords(table, "names", course.names, course, list); });
    list.Try([&] { ReadWords(table, "mates", course.mates, course, list); });
    list.Try([&] { lessons = ReadLessonIds(table, course); });
    list.AddUnknown(table);
  });
  return course;
}

CourseReading ReadCourse(const std::string& name_or_path) {
  const std::string path = CoursePath(name_or_path);
  const std::string toml = ReadTextFile(path, kMostBytes);
  CourseReading reading;
  std::vector<std::string> ids;
  reading.course = ParseCourse(toml, path, ids, reading.faults);
  if (!ids.empty()) LessonFiles(path, reading).Read(ids);
  return reading;
}

std::vector<CourseFault> FaultsOfUnlisted(const CourseReading& reading) {
  std::vector<CourseFault> faults;
  for (const std::string& file : reading.unlisted) {
    try {
      ParseLesson(ReadTextFile(file, kMostBytes), file, reading.course, faults);
    } catch (const InputError& error) {  // "path: what"
      faults.push_back({file, 0, 0, std::string(error.what()).substr(file.size() + 2)});
    }
  }
  return faults;
}

Course LoadCourse(const std::string& name_or_path) {
  CourseReading reading = ReadCourse(name_or_path);
  if (reading.faults.empty()) reading.faults = CheckReach(reading.course);
  if (!reading.faults.empty()) throw InputError(LineOf(reading.faults.front()));
  AddSpellings(reading.course);
  return std::move(reading.course);
}

}  // namespace moontrace
