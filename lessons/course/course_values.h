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

/// Readers of values in course and lesson files, with their bounds. All throw InputError:
/// file:line:column, cause, cure.

/// At most so many lessons of a course, steps of a lesson, items of a list, entries of a table;
/// bytes of an item, of a title, a name or a hint, of a text. They limit what a hostile file can
/// cost.
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

/// Whether a text holds nothing but spaces and line ends.
bool IsBlank(std::string_view text);

/// Collects what is wrong with one file, so that a reader can continue after a fault.
class FaultList {
 public:
  FaultList(std::string file, std::vector<CourseFault>& faults)
      : file_(std::move(file)), faults_(faults) {}

  /// Runs `work`; records the message of an InputError that it throws.
  template <class Work>
  void Try(const Work& work) {
    try {
      work();
    } catch (const InputError& error) {
      Add(error.what());
    }
  }

  /// Records the keys of a table that no getter has asked for.
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
