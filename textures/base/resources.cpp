#include "textures/base/resources.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "textures/base/error.h"

namespace moontrace {

namespace fs = std::filesystem;

std::string ResourcePath(const std::string& relative) {
  std::error_code ignored;
  if (const char* data = std::getenv("MOONTRACE_DATA"); data != nullptr && *data != '\0') {
    const fs::path path = fs::path(data) / relative;
    if (fs::exists(path, ignored)) return path.string();
    throw LackError("file missing: " + path.string() + "; MOONTRACE_DATA names the wrong folder");
  }
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  const fs::path installed = program.parent_path() / "share" / "moontrace" / relative;
  if (fs::exists(installed, ignored)) return installed.string();
  const fs::path source = fs::path(MOONTRACE_SOURCE_DIR) / relative;
  if (fs::exists(source, ignored)) return source.string();
  throw LackError("file missing: " + relative +
                  "; install the program again or set MOONTRACE_DATA");
}

}  // namespace moontrace
