#pragma once

#include <string>

#include "lessons/records/records.h"
#include "sim/setup/options.h"

namespace moontrace {

/// `records list|export NAME|import FILE|erase NAME|consent NAME yes|no`: what the program knows of
/// learners, in their own hands.
struct RecordsOptions {
  OutputOptions output;
  std::string action;
  std::string subject;  ///< learner, or file of an import
  std::string answer;   ///< of consent
  std::string records;  ///< file; empty: the user's
  std::string to;       ///< file of an export; empty: standard output
  bool anonymous = false;
  bool yes = false;
};
void AddOptions(CLI::App& app, RecordsOptions& options);
int Run(const RecordsOptions& options, Console& console);

/// The records to look into: those named, else the user's.
std::string RecordsPathOf(const std::string& given);

/// Throws InputError, naming the nearest, for a learner who is not in the records.
LearnerEntry KnownLearner(const Records& records, const std::string& name);

}  // namespace moontrace
