#pragma once

#include <string>

namespace moontrace {

/// Makes the folder (0700, with those above it) and an empty file (0600) where there are none.
/// Throws LackError.
void MakeRecordsFile(const std::string& path);

/// Takes the rights of group and others from a file, as far as that is allowed.
void MakePrivate(const std::string& path);

/// Held by the one program that writes to a records file, in an empty file "PATH-lock" beside it:
/// SQLite's own locks last for one transaction only. Ends with the program, however it ends.
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
