#pragma once

#include <string>
#include <string_view>

#include "textures/base/file_descriptor.h"

namespace moontrace {

/// Makes a folder, with those above it, where there is none; it outlasts a power cut. Throws
/// LackError.
void MakeFolder(const std::string& folder);

/// Throws LackError, one line, where WriteWhole cannot write. Leaves nothing behind.
void RequireWritable(const std::string& path);

/// A file that is written part by part: first beside its place, then renamed by Finish, so that
/// nothing half-written is left, not even by a power cut: the bytes are on disk before the name is,
/// and both when Finish returns. Without Finish what was written goes. Behind a symbolic link the
/// file that it names is written; what is there and no file (a folder, a pipe, a device) is left
/// alone. All throw LackError.
class OutputFile {
 public:
  /// Not `lasting`: nothing waits for the disk, and a power cut may take it; for what is one of
  /// many and soon made again, as frames are.
  explicit OutputFile(const std::string& path, bool lasting = true);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();
  void Append(std::string_view bytes);
  void Finish();

 private:
  std::string partial() const { return place_ + ".partial"; }
  void Flush();
  [[noreturn]] void Fail() const;

  std::string path_, place_;
  FileDescriptor file_;
  std::string buffer_;
  bool lasting_ = true;
  bool placed_ = false;
};

/// Writes all of a file, as an OutputFile.
void WriteWhole(const std::string& path, const std::string& bytes, bool lasting = true);

}  // namespace moontrace
