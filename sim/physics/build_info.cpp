#include "sim/physics/build_info.h"

#include <fmt/core.h>
#include <mujoco/mujoco.h>

#include <fstream>

namespace moontrace {
namespace {

std::string Compiler() {
#if defined(__clang__)
  return fmt::format("Clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
  return fmt::format("GCC {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
  return "unknown";
#endif
}

std::string Processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) != 0) continue;
    const std::size_t begin = line.find_first_not_of(" \t:", line.find(':'));
    return begin == std::string::npos ? "" : line.substr(begin);
  }
  return "";
}

std::string ProcessorFeatures() {
  std::string features;
#if defined(__x86_64__)
  const auto add = [&features](bool present, const char* name) {
    if (!present) return;
    if (!features.empty()) features += ' ';
    features += name;
  };
  add(__builtin_cpu_supports("sse4.2") != 0, "sse4.2");
  add(__builtin_cpu_supports("avx") != 0, "avx");
  add(__builtin_cpu_supports("avx2") != 0, "avx2");
  add(__builtin_cpu_supports("fma") != 0, "fma");
  add(__builtin_cpu_supports("avx512f") != 0, "avx512f");
#endif
  return features;
}

}  // namespace

BuildInfo ThisBuild() {
  BuildInfo build;
  build.program_version = MOONTRACE_VERSION;
  build.compiler = Compiler();
  build.flags = MOONTRACE_BUILD_FLAGS;
  build.mujoco_compiled = mjVERSION_HEADER;
  build.mujoco_run = mj_version();
  build.cpu = Processor();
  build.cpu_features = ProcessorFeatures();
  return build;
}

std::string MadeBy(const BuildInfo& build) {
  return fmt::format("moontrace {}, {}, MuJoCo {}, {}", build.program_version, build.compiler,
                     build.mujoco_run, build.cpu.empty() ? "unknown processor" : build.cpu);
}

}  // namespace moontrace
