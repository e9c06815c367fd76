#pragma once

#include <string>

namespace moontrace {

/// Makes the folder (0700, with those above it) and an empty file (0600) where there are none.
/// Throws LackError.
void MakeRecordsFile(const std::string& path);

/// Removes the permissions of group and others from a file, as far as that is allowed.
void MakePrivate(const std::string& path);

/// A lock on an empty file "PATH-lock", held by the one program that writes to the records file:
/// SQLite's own locks last for one transaction only. Released when the program ends, however it
/// ends.
class WriterLock {
 public:
  /// Throws LackError: held by another program, cannot be made.
  explicit WriterLock(const std::string& path);
  ~WriterLock();
  WriterLock(const WriterLock&) = delete;
  WriterLock& operator=(const WriterLock&) = delete;

 private:
  int file_ = -1;
};

}  // namespace moontrace
