#pragma once

#include <string>

namespace moontrace {

/// Makes a folder where there is none. Throws LackError.
void MakeFolder(const std::string& folder);

/// Throws LackError, one line, where WriteWhole cannot write. Leaves nothing behind.
void RequireWritable(const std::string& path);

/// Writes a file first beside its place, then renames it: nothing half-written is left. Behind a
/// symbolic link the file that it names is written; what is there and no file (a folder, a pipe, a
/// device) is left alone. Throws LackError.
void WriteWhole(const std::string& path, const std::string& bytes);

}  // namespace moontrace
