#pragma once

#include <string>
#include <vector>

#include "sim/setup/options.h"

namespace moontrace {

/// `course check PATH...|show [PATH]`: what is wrong with courses and lessons; what they teach.
struct CourseOptions {
  OutputOptions output;
  std::vector<std::string> words;  ///< the action, then courses
  std::string device;              ///< check: a profile's name; empty = no size is too small
};
void AddOptions(CLI::App& app, CourseOptions& options);
int Run(const CourseOptions& options, Console& console);

}  // namespace moontrace
