#pragma once

#include <string>

#include "textures/base/file_descriptor.h"

namespace moontrace {

/// Makes the folder (0700, with those above it) and an empty file (0600) where there are none; the
/// folders outlast a power cut. Throws LackError.
void MakeRecordsFile(const std::string& path);

/// Throws InputError for a symbolic link: what it leads to could be changed under a program that
/// writes, and its journal would lie beside the link. A path that leads nowhere passes.
void RequireNoLink(const std::string& path);

/// Removes the permissions of group and others from a file, as far as that is allowed.
void MakePrivate(const std::string& path);

/// Held by the one program that writes to the records file: SQLite's own locks last for one
/// transaction only. It lies on the file itself, so that another name of it (a hard link) gives no
/// second writer, and on an empty file "PATH-lock", which earlier programs know. Released when the
/// program ends, however it ends.
class WriterLock {
 public:
  /// The file must be there. Throws LackError: held by another program, cannot be made; InputError:
  /// one of the two is a symbolic link.
  explicit WriterLock(const std::string& path);

 private:
  FileDescriptor beside_, itself_;
};

}  // namespace moontrace
