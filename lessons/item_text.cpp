#include "lessons/item_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/course_reader.h"
#include "textures/error.h"
#include "textures/text_file.h"

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

bool IsBlank(std::string_view text) { return text.find_first_not_of(" \n") == text.npos; }

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

std::vector<std::string> ReadItems(const TomlTable& table, const std::string& key) {
  std::vector<std::string> items = table.Strings(key);
  if (items.size() > kMostItems) {
    table.Fail(key, fmt::format("more than {}; give fewer", kMostItems));
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string& item = items[i];
    const bool blank =
        std::any_of(item.begin(), item.end(), [](char c) { return IsControl(c) || c == ' '; });
    if (item.empty() || item.size() > kMostItem || blank) {
      FailAt(table, key, i,
             fmt::format("'{}' is not one word of 1 to {} bytes; correct it", OneLine(item, 24),
                         kMostItem));
    }
  }
  return items;
}

}  // namespace moontrace
