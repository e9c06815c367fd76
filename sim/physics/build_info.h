#pragma once

#include <string>

namespace moontrace {

/// What produced a record. Replays are bit-equal for one binary on one kind of processor (libm
/// picks its functions by processor), so a record names it.
struct BuildInfo {
  std::string program_version;
  std::string compiler;
  std::string flags;
  int mujoco_compiled = 0;   ///< mjVERSION_HEADER
  int mujoco_run = 0;        ///< mj_version()
  std::string cpu;           ///< the processor's name, empty where the system does not say
  std::string cpu_features;  ///< those by which compilers and libm choose code, space between
};

/// This program on this machine.
BuildInfo ThisBuild();

/// One line for messages, e.g. "moontrace 0.1.0, GCC 12.2.0, MuJoCo 222, <processor>".
std::string MadeBy(const BuildInfo& build);

}  // namespace moontrace
