#pragma once

#include <cstdint>
#include <string>

#include "sim/setup/options.h"

namespace moontrace {

/// `demo`: a newcomer's first minute. Traces a word at four sizes and on blank paper, and leaves
/// pictures.
struct DemoOptions {
  OutputOptions output;
  std::uint64_t seed = 1;
  std::string folder = "moontrace-demo";
};
void AddOptions(CLI::App& app, DemoOptions& options);
int Run(const DemoOptions& options, Console& console);

}  // namespace moontrace
