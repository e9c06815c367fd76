#pragma once

#include <string>

namespace moontrace {

/// The path of a file or folder of the source tree that the tests were built from, such as
/// "devices/hand.toml".
std::string SourcePath(const std::string& relative);

}  // namespace moontrace
