#include "lessons/course/item_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "lessons/course/course_reader.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

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

}  // namespace moontrace
