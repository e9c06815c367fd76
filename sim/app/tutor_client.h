#pragma once

#include <string>

#include "sim/setup/options.h"
#include "sim/wording/console.h"

namespace moontrace {

/// `moontrace tutor`: lines of the tutor to a running lesson, and its lines back. Ends when the
/// lesson ends, when the tutor says quit, and when standard input has ended and all is answered.
struct TutorOptions {
  std::string learner;  ///< empty: the only one whose lesson runs
  OutputOptions output;
};

void AddOptions(CLI::App& app, TutorOptions& options);
/// Throws LackError: no lesson runs, or several and none was chosen.
int Run(const TutorOptions& options, Console& console);

}  // namespace moontrace
