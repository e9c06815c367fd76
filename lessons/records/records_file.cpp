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
}

}  // namespace

void MakeRecordsFile(const std::string& path) {
  MakePrivateFolder(fs::absolute(path).parent_path());
  const int made = open(path.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (made < 0 && errno != EEXIST) Refuse(path, errno);
  if (made >= 0) close(made);
}

void MakePrivate(const std::string& path) {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0 || (found.st_mode & (S_IRWXG | S_IRWXO)) == 0) return;
  static_cast<void>(chmod(path.c_str(), found.st_mode & S_IRWXU));
}

WriterLock::WriterLock(const std::string& path) {
  const std::string name = path + "-lock";
  file_ = open(name.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (file_ < 0) {
    throw LackError(path + ": these records can only be read; give write permission to the folder");
  }
  if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
  close(file_);
  throw LackError(path + ": another program writes these records; close it and try again");
}

WriterLock::~WriterLock() { close(file_); }

}  // namespace moontrace
