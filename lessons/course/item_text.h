#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "textures/base/toml_reader.h"

namespace moontrace {

/// Values of course and lesson files, read and held to their bounds (course_reader.h). All throw
/// InputError: file:line:column, cause, cure.

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

}  // namespace moontrace
