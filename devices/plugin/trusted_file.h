#pragma once

#include <string>

#include "textures/base/file_descriptor.h"

namespace moontrace {

/// Opens a file for reading that nobody but root and this user could have written or exchanged: it
/// and every folder above it, links followed, belong to one of them and can be written by no other.
/// A folder that all may write but whose entries only their owners may exchange (/tmp, with the
/// sticky bit) may lie above the file's folder, but not hold the file itself. What was checked is
/// what is opened, whatever happens to the names meanwhile. Throws DeviceError with the file or
/// folder at fault and the command that mends it.
FileDescriptor OpenTrusted(const std::string& path);

}  // namespace moontrace
