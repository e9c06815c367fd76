#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/setup/options.h"

namespace moontrace {

/// `study FILE | merge A B ...`: simulated learners by a protocol.
struct StudyOptions {
  OutputOptions output;
  std::vector<std::string> words;  ///< a protocol, or "merge" and files
  std::string path;                ///< of the rows; empty: by the protocol's name
  std::optional<double> threads;   ///< whole; none: one a core
  std::string shard;               ///< "K/N"; empty: all
};
void AddOptions(CLI::App& app, StudyOptions& options);
int Run(const StudyOptions& options, Console& console);

}  // namespace moontrace
