#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "textures/base/digest.h"

namespace moontrace {

/// A new file, written through a buffer, every step checked: a full disk is noticed, at the latest
/// by Close. Keeps the digest of all that was written. Throws LackError: path, cause, cure.
class FileSink {
 public:
  /// Makes `path`, which must not exist. The buffer is allocated here.
  explicit FileSink(std::string path);
  /// Closes silently; what is still buffered is lost. Call Close for a file to be kept.
  ~FileSink();
  FileSink(const FileSink&) = delete;
  FileSink& operator=(const FileSink&) = delete;

  void Write(std::string_view bytes);
  /// Writes out what is buffered; others can read it then.
  void Flush();
  /// Flushes, has the system put the bytes on the disk, closes.
  void Close();

  const std::string& path() const { return path_; }
  const Digest& digest() const { return digest_; }

 private:
  [[noreturn]] void Fail(int error) const;

  std::string path_;
  int file_ = -1;
  std::vector<char> buffer_;
  std::size_t used_ = 0;
  Digest digest_;
};

}  // namespace moontrace
