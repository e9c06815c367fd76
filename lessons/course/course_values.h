#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lessons/course/course.h"
#include "textures/base/error.h"
#include "textures/base/toml_reader.h"

namespace moontrace {

/// Values of course and lesson files, read and held to their bounds. What reads one throws
/// InputError: file:line:column, cause, cure.

/// Most lessons of a course, steps of a lesson, items of a list, entries of a table; bytes of an
/// item, of a title, a name or a hint, of a text. They bound what a hostile file can cost.
constexpr std::size_t kMostLessons = 200, kMostSteps = 100, kMostItems = 100, kMostEntries = 500,
                      kMostItem = 64, kMostLine = 600, kMostCourseText = 20000;

/// A text of one or more lines, without other control characters.
std::string ReadCourseText(const TomlTable& table, const std::string& key, std::size_t most);

/// A title, a name: one line with something on it.
std::string ReadCourseLine(const TomlTable& table, const std::string& key);

/// At most so many items, each without blanks, so that two can stand side by side. Where one is
/// wrong the others are in `items` all the same.
void ReadItems(const TomlTable& table, const std::string& key, std::size_t most,
               std::vector<std::string>& items);

/// A size of letters in millimetres that stands at `key`, in metres.
double ReadSize(const TomlTable& table, const std::string& key, double size_mm);

/// Nothing but spaces and line ends.
bool IsBlank(std::string_view text);

/// Gathers what is wrong with one file, so that a reader can go on behind a fault.
class FaultList {
 public:
  FaultList(std::string file, std::vector<CourseFault>& faults)
      : file_(std::move(file)), faults_(faults) {}

  /// Does the work; what an InputError says is noted.
  template <class Work>
  void Try(const Work& work) {
    try {
      work();
    } catch (const InputError& error) {
      Add(error.what());
    }
  }

  /// The keys of a table that nobody has asked for.
  void AddUnknown(const TomlTable& table) {
    for (const std::string& line : table.Unknown()) Add(line);
  }

  /// A line of InputError: "file:line:column: what".
  void Add(const std::string& line);

 private:
  std::string file_;
  std::vector<CourseFault>& faults_;
};

}  // namespace moontrace
