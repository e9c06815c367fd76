#include "devices/plugin/trusted_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstring>
#include <filesystem>
#include <list>
#include <system_error>

#include "devices/core/device_error.h"

namespace moontrace {
namespace {

constexpr int kMostLinks = 40;  // as the kernel's own limit
constexpr ::mode_t kOthersWrite = S_IWGRP | S_IWOTH;

std::string ReadLink(const char* path, int folder) {
  std::array<char, PATH_MAX> target{};
  const ::ssize_t size = readlinkat(folder, path, target.data(), target.size());
  return size > 0 ? std::string(target.data(), static_cast<std::size_t>(size)) : std::string();
}

std::string ThroughProc(const FileDescriptor& fd) {
  return fmt::format("/proc/self/fd/{}", fd.get());
}

/// Where the walk is: a folder that has been checked with everything above it.
class Walk {
 public:
  explicit Walk(const std::string& path) : path_(path) {}

  FileDescriptor ToFile() {
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::absolute(path_, error);
    if (path_.empty() || error) Refuse("name a file");
    Prepend(whole.string());
    StartAtRoot();
    while (!ahead_.empty()) {
      const std::string name = ahead_.front();
      ahead_.pop_front();
      if (name.empty() || name == ".") continue;
      if (FileDescriptor file = Step(name)) return file;
    }
    Refuse("it is a folder: name a file in it");
  }

 private:
  [[noreturn]] void Refuse(const std::string& why) const {
    throw DeviceError(fmt::format("{}: not loaded: {}", path_, why));
  }

  void Prepend(const std::string& path) {
    auto at = ahead_.begin();
    std::size_t begin = 0;
    while (begin <= path.size()) {
      const std::size_t end = std::min(path.find('/', begin), path.size());
      ahead_.insert(at, path.substr(begin, end - begin));
      begin = end + 1;
    }
  }

  void StartAtRoot() {
    folder_ = FileDescriptor(open("/", O_PATH | O_DIRECTORY | O_CLOEXEC));
    CheckFolder(Status(folder_));
  }

  /// Goes on by one name; the file if it was reached.
  FileDescriptor Step(const std::string& name) {
    FileDescriptor next(openat(folder_.get(), name.c_str(), O_PATH | O_NOFOLLOW | O_CLOEXEC));
    if (!next) {
      Refuse(fmt::format("{} in {}: {}", name, Place(folder_), std::strerror(errno)));
    }
    const struct ::stat status = Status(next);
    if (S_ISLNK(status.st_mode)) {
      CheckOwner(status, fmt::format("{}/{}", Place(folder_), name));
      if (++links_ > kMostLinks) Refuse("too many symbolic links: name the file itself");
      const std::string target = ReadLink("", next.get());
      Prepend(target);
      if (!target.empty() && target.front() == '/') StartAtRoot();
      return FileDescriptor();
    }
    if (S_ISDIR(status.st_mode)) {
      folder_ = std::move(next);
      CheckFolder(status);
      return FileDescriptor();
    }
    return OpenFile(next, status);
  }

  FileDescriptor OpenFile(const FileDescriptor& found, const struct ::stat& status) {
    const std::string place = Place(found);
    if (!S_ISREG(status.st_mode) || !ahead_.empty()) {
      Refuse(fmt::format("{} is no {}", place, ahead_.empty() ? "plain file" : "folder"));
    }
    if (shared_) {
      Refuse(fmt::format("all users may write into its folder {}: move it to a folder of your own",
                         Place(folder_)));
    }
    CheckOwner(status, place);
    if ((status.st_mode & kOthersWrite) != 0) {
      Refuse(fmt::format("others may write the file: chmod go-w {}", place));
    }
    FileDescriptor file(open(ThroughProc(found).c_str(), O_RDONLY | O_CLOEXEC));
    if (!file) Refuse(fmt::format("{}: chmod u+r {}", std::strerror(errno), place));
    return file;
  }

  void CheckFolder(const struct ::stat& status) {
    CheckOwner(status, Place(folder_));
    shared_ = (status.st_mode & kOthersWrite) != 0;
    if (shared_ && (status.st_mode & S_ISVTX) == 0) {
      Refuse(fmt::format("others may write into the folder {0}: chmod go-w {0}", Place(folder_)));
    }
  }

  void CheckOwner(const struct ::stat& status, const std::string& place) const {
    if (status.st_uid == 0 || status.st_uid == geteuid()) return;
    Refuse(fmt::format("{0} belongs to another user (number {1}): chown {2} {0}", place,
                       status.st_uid, geteuid()));
  }

  struct ::stat Status(const FileDescriptor& fd) const {
    struct ::stat status = {};
    if (!fd || fstat(fd.get(), &status) != 0) Refuse(std::strerror(errno));
    return status;
  }

  static std::string Place(const FileDescriptor& fd) {
    return ReadLink(ThroughProc(fd).c_str(), AT_FDCWD);
  }

  std::string path_;
  std::list<std::string> ahead_;  ///< names still to go
  FileDescriptor folder_;
  bool shared_ = false;  ///< the folder is one that all may write
  int links_ = 0;
};

}  // namespace

FileDescriptor OpenTrusted(const std::string& path) { return Walk(path).ToFile(); }

}  // namespace moontrace
