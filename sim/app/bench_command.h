#pragma once

#include "sim/app/options.h"

namespace moontrace {

/// `bench`: measures what the design promises, each beside what it is compared with in the same
/// run.
struct BenchOptions {
  OutputOptions output;
};
void AddOptions(CLI::App& app, BenchOptions& options);
int Run(const BenchOptions& options, Console& console);

}  // namespace moontrace
