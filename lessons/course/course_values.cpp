#include "lessons/course/course_values.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <iterator>

#include "textures/base/text_file.h"
#include "textures/base/units.h"

namespace moontrace {
namespace {

// Letters below 1 mm cannot be set (typeset.h); a sheet ends at 5 m, a hand's reach long before.
constexpr double kLeastSize = 1, kMostSize = 300;  // [mm]

bool IsControl(char c) { return static_cast<unsigned char>(c) < 0x20U || c == '\x7f'; }

/// Where the first of an array's elements is wrong: "file:line:column: key: problem".
[[noreturn]] void FailAt(const TomlTable& table, const std::string& key, std::size_t element,
                         const std::string& problem) {
  const TextPlace whole = table.PlaceOf(key);
  const TextPlace place = table.PlaceOf(key, element);
  const std::string where = table.Where(key);
  const std::string tail = fmt::format(":{}:{}", whole.line, whole.column);
  throw InputError(fmt::format("{}:{}:{}: {}: {}", where.substr(0, where.size() - tail.size()),
                               place.line, place.column, key, problem));
}

/// Reads "12:" at `at` and steps behind it; 0 and no step where there is none.
std::size_t ReadPlace(const std::string& line, std::size_t& at) {
  std::size_t number = 0;
  const char* begin = line.data() + at;
  const auto result = std::from_chars(begin, line.data() + line.size(), number);
  if (result.ec != std::errc() || *result.ptr != ':') return 0;
  at = static_cast<std::size_t>(result.ptr - line.data()) + 1;
  return number;
}

}  // namespace

bool IsBlank(std::string_view text) {
  return text.find_first_not_of(" \n") == std::string_view::npos;
}

std::string ReadCourseText(const TomlTable& table, const std::string& key, std::size_t most) {
  std::string text = table.String(key);
  if (text.size() > most) {
    table.Fail(key, fmt::format("longer than {} bytes; shorten it", most));
  }
  for (const char c : text) {
    if (IsControl(c) && c != '\n') {
      table.Fail(key, "holds a control character; write plain text");
    }
  }
  return text;
}

std::string ReadCourseLine(const TomlTable& table, const std::string& key) {
  std::string line = ReadCourseText(table, key, kMostLine);
  if (IsBlank(line)) table.Fail(key, "empty; write something");
  if (line.find('\n') != std::string::npos) table.Fail(key, "more than one line; write one");
  return line;
}

void ReadItems(const TomlTable& table, const std::string& key, std::size_t most,
               std::vector<std::string>& items) {
  const std::vector<std::string> given = table.Strings(key);
  if (given.size() > most) table.Fail(key, fmt::format("more than {}; give fewer", most));
  const auto wrong = [](const std::string& item) {
    return item.empty() || item.size() > kMostItem ||
           std::any_of(item.begin(), item.end(), [](char c) { return IsControl(c) || c == ' '; });
  };
  std::copy_if(given.begin(), given.end(), std::back_inserter(items),
               [&](const std::string& item) { return !wrong(item); });
  const auto first = std::find_if(given.begin(), given.end(), wrong);
  if (first == given.end()) return;
  FailAt(table, key, static_cast<std::size_t>(first - given.begin()),
         fmt::format("'{}' is not one word of 1 to {} bytes; correct it", OneLine(*first, 24),
                     kMostItem));
}

double ReadSize(const TomlTable& table, const std::string& key, double size_mm) {
  if (!(size_mm >= kLeastSize && size_mm <= kMostSize)) {
    table.Fail(key, "not from 1 to 300 mm; correct it");
  }
  return kMillimetre * size_mm;
}

void FaultList::Add(const std::string& line) {
  CourseFault fault;
  fault.file = file_;
  std::size_t at = 0;
  if (line.rfind(file_ + ":", 0) == 0) {
    at = file_.size() + 1;
    fault.line = ReadPlace(line, at);
    if (fault.line > 0) fault.column = ReadPlace(line, at);
    if (at < line.size() && line[at] == ' ') ++at;
  }
  fault.what = line.substr(at);
  faults_.push_back(std::move(fault));
}

}  // namespace moontrace
