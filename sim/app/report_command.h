#pragma once

#include <string>

#include "sim/setup/options.h"

namespace moontrace {

/// `report NAME [--html F | --csv F]`: how a learner does, from the records.
struct ReportOptions {
  OutputOptions output;
  std::string learner, course, records, html, csv;
};
void AddOptions(CLI::App& app, ReportOptions& options);
int Run(const ReportOptions& options, Console& console);

}  // namespace moontrace
