#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lessons/course/course.h"
#include "textures/base/error.h"
#include "textures/base/toml_reader.h"

namespace moontrace {

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
