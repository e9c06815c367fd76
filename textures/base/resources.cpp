#include "textures/base/resources.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "textures/base/error.h"

namespace moontrace {

namespace fs = std::filesystem;

namespace {

constexpr int kMostUp = 2;  ///< folders, from lib/x86_64-linux-gnu/ to where share/ lies

/// The file that this code was loaded from, a program or a library; empty if that is not known.
fs::path OwnFile() {
  Dl_info own;
  std::error_code ignored;
  if (dladdr(reinterpret_cast<const void*>(&ResourcePath), &own) == 0) return {};
  return fs::canonical(own.dli_fname, ignored);
}

/// Below share/moontrace beside the folder of `file` or further up; empty if it is not there.
fs::path InstalledBeside(const fs::path& file, const std::string& relative) {
  std::error_code ignored;
  fs::path folder = file.parent_path();
  for (int up = 0; up < kMostUp && folder.has_relative_path(); ++up) {
    folder = folder.parent_path();
    fs::path installed = folder / "share" / "moontrace" / relative;
    if (fs::exists(installed, ignored)) return installed;
  }
  return {};
}

}  // namespace

std::string ResourcePath(const std::string& relative) {
  std::error_code ignored;
  if (const char* data = std::getenv("MOONTRACE_DATA"); data != nullptr && *data != '\0') {
    const fs::path path = fs::path(data) / relative;
    if (fs::exists(path, ignored)) return path.string();
    throw LackError("file missing: " + path.string() + "; MOONTRACE_DATA names the wrong folder");
  }
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  for (const fs::path& file : {OwnFile(), program}) {
    const fs::path installed = InstalledBeside(file, relative);
    if (!installed.empty()) return installed.string();
  }
  const fs::path source = fs::path(MOONTRACE_SOURCE_DIR) / relative;
  if (fs::exists(source, ignored)) return source.string();
  throw LackError("file missing: " + relative +
                  "; install the program again or set MOONTRACE_DATA");
}

}  // namespace moontrace
