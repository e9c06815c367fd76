#include "lessons/course/fault_list.h"

#include <charconv>

namespace moontrace {
namespace {

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
