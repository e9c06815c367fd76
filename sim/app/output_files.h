#pragma once

#include <string>

namespace moontrace {

/// Makes a folder where there is none. Throws LackError.
void MakeFolder(const std::string& folder);

/// Writes a file first beside its place, then renames it: nothing half-written is left. Throws
/// LackError.
void WriteWhole(const std::string& path, const std::string& bytes);

}  // namespace moontrace
