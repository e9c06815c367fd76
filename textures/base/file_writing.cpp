#include "textures/base/file_writing.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "textures/base/file_descriptor.h"

namespace moontrace {

bool WriteAll(int file, std::string_view bytes) noexcept {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    if (count == 0) {  // no file of ours does that, and it must not go on for ever
      errno = ENOSPC;
      return false;
    }
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool SyncFile(int file) noexcept {
  while (::fsync(file) != 0) {
    if (errno == EINVAL || errno == ENOTSUP) return true;
    if (errno != EINTR) return false;
  }
  return true;
}

bool SyncFolder(const std::string& folder) noexcept {
  const char* const path = folder.empty() ? "." : folder.c_str();
  for (;;) {
    const FileDescriptor opened(::open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (opened) return SyncFile(opened.get());
    if (errno == EACCES) return true;
    if (errno != EINTR) return false;
  }
}

std::string FolderOf(const std::string& path) {
  return std::filesystem::path(path).parent_path().string();
}

}  // namespace moontrace
