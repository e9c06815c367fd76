#include "tests/source_path.h"

namespace moontrace {

std::string SourcePath(const std::string& relative) {
  return std::string(MOONTRACE_SOURCE_DIR) + "/" + relative;
}

}  // namespace moontrace
