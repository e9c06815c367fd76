#pragma once

#include <cstdint>
#include <string>

#include "lessons/course/course.h"
#include "sim/console/console.h"

namespace moontrace {

/// `learn --simulate`: a simulated learner goes through a course, unattended.
struct LearnSimulatedOptions {
  std::uint64_t seed = 1;
  int days = 0;         ///< sessions, one a day; 0: until the course is done
  std::string records;  ///< file to keep the trials in; empty: they are only summed up
  std::string learner;  ///< pseudonym in it; empty: "simulated"
  std::string model;    ///< of the learner, TOML; empty: the shipped one
};

/// Prints each lesson that is done and what came of it all. Throws InputError (model, records),
/// LackError, UsageError (the pseudonym is a person's), WorkFailed where the learner was stuck.
int LearnSimulated(const LearnSimulatedOptions& options, const Course& course, Console& console);

}  // namespace moontrace
