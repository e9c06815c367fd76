#include "lessons/records/records_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "textures/base/error.h"
#include "textures/base/file_writing.h"

namespace moontrace {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void Refuse(const fs::path& path, int error) {
  throw LackError(fmt::format("{}: cannot be made: {}; name another place by --records",
                              path.string(), std::strerror(error)));
}

void MakePrivateFolder(const fs::path& folder) {
  std::error_code ignored;
  if (folder.empty() || fs::is_directory(folder, ignored)) return;
  MakePrivateFolder(folder.parent_path());
  if (mkdir(folder.c_str(), S_IRWXU) != 0 && errno != EEXIST) Refuse(folder, errno);
  if (!SyncFolder(folder.parent_path().string())) Refuse(folder, errno);
}

FileDescriptor Opened(const std::string& path, int flags) {
  constexpr mode_t kOwners = S_IRUSR | S_IWUSR;
  for (;;) {
    FileDescriptor file(open(path.c_str(), flags | O_RDWR | O_NOFOLLOW | O_CLOEXEC, kOwners));
    if (file || errno != EINTR) return file;
  }
}

[[noreturn]] void RefuseSecond(const std::string& path) {
  throw LackError(path + ": another program writes these records; close it and try again");
}

/// A lock on a byte that SQLite never locks (it keeps to the 512 from 1 GiB on), of the open file
/// and not of the process: false, as for others, where this process holds it already.
bool LockByte(const FileDescriptor& file) {
  struct flock byte {};
  byte.l_type = F_WRLCK;
  byte.l_whence = SEEK_SET;
  byte.l_start = off_t{1} << 62U;
  byte.l_len = 1;
  return fcntl(file.get(), F_OFD_SETLK, &byte) == 0;
}

}  // namespace

void MakeRecordsFile(const std::string& path) {
  MakePrivateFolder(fs::absolute(path).parent_path());
  const FileDescriptor made = Opened(path, O_CREAT | O_EXCL);
  if (!made && errno != EEXIST) Refuse(path, errno);
}

void RequireNoLink(const std::string& path) {
  std::error_code ignored;
  if (!fs::is_symlink(path, ignored)) return;
  throw InputError(path + ": is a symbolic link; name the file that it leads to");
}

void MakePrivate(const std::string& path) {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0 || (found.st_mode & (S_IRWXG | S_IRWXO)) == 0) return;
  static_cast<void>(chmod(path.c_str(), found.st_mode & S_IRWXU));
}

WriterLock::WriterLock(const std::string& path) {
  RequireNoLink(path);
  const std::string name = path + "-lock";
  beside_ = Opened(name, O_CREAT);
  if (!beside_) {
    const int error = errno;
    RequireNoLink(name);
    if (error != EACCES && error != EPERM && error != EROFS) Refuse(name, error);
    throw LackError(path + ": these records can only be read; give write permission to the folder");
  }
  if (flock(beside_.get(), LOCK_EX | LOCK_NB) != 0) RefuseSecond(path);
  itself_ = Opened(path, 0);
  // one that may only be read cannot be locked so: SQLite says that it cannot be written
  if (!itself_ && errno != EACCES && errno != EROFS) Refuse(path, errno);
  if (itself_ && !LockByte(itself_) && (errno == EAGAIN || errno == EACCES)) RefuseSecond(path);
}

}  // namespace moontrace
