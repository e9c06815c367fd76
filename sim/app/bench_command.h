#pragma once

#include "sim/setup/options.h"

namespace moontrace {

/// `bench`: measures what the design promises, each beside what it is compared with in the same
/// run. With `--stability` or `--heat` only what they name: what devices hold without buzzing, and
/// how warm their motors become.
struct BenchOptions {
  OutputOptions output;
  bool stability = false;
  bool heat = false;
};
void AddOptions(CLI::App& app, BenchOptions& options);
int Run(const BenchOptions& options, Console& console);

}  // namespace moontrace
