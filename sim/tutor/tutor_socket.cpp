#include "sim/tutor/tutor_socket.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "sim/tutor/tutor_messages.h"
#include "textures/base/digest.h"
#include "textures/base/error.h"

namespace moontrace {

namespace {

constexpr std::string_view kBegin = "tutor-";
constexpr std::string_view kEnd = ".sock";
constexpr std::size_t kLongestName = 60;  // of 108 bytes that a socket's path may have
constexpr int kAtOnce = 8;                // waiting to be let in

std::string Cause(int error) { return std::generic_category().message(error); }

[[noreturn]] void FailToOpen(const std::string& path, int error) {
  throw LackError(say::CannotOpenSocket(path, Cause(error)));
}

bool IsPlain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
         c == '_' || c == '.';
}

struct flock WholeFile() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

/// Whether a live program holds the lock; asked without taking it.
bool IsLocked(const std::string& path) {
  const FileDescriptor file(open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW));
  struct flock lock = WholeFile();
  return file && fcntl(file.get(), F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

int HexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// The file that says whose the socket is, locked; invalid if another holds it. A file that was
/// removed between opening and locking is no lock.
FileDescriptor Lock(const std::string& path) {
  while (true) {
    FileDescriptor file(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600));
    if (!file) FailToOpen(path, errno);
    struct flock lock = WholeFile();
    if (fcntl(file.get(), F_OFD_SETLK, &lock) != 0) return FileDescriptor();
    struct stat mine {};
    struct stat there {};
    if (fstat(file.get(), &mine) == 0 && stat(path.c_str(), &there) == 0 &&
        mine.st_ino == there.st_ino && mine.st_dev == there.st_dev) {
      return file;
    }
  }
}

}  // namespace

std::string TutorFolder() {
  const char* runtime = std::getenv("XDG_RUNTIME_DIR");
  if (runtime != nullptr && runtime[0] == '/') return std::string(runtime) + "/moontrace";
  return fmt::format("/tmp/moontrace-{}", getuid());
}

void RequireTutorFolder(const std::string& folder) {
  if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) FailToOpen(folder, errno);
  struct stat found {};
  if (lstat(folder.c_str(), &found) != 0) FailToOpen(folder, errno);
  if (!S_ISDIR(found.st_mode) || found.st_uid != getuid()) {
    throw LackError(say::FolderNotOurs(folder));
  }
  if ((found.st_mode & 077U) != 0) throw LackError(say::FolderOpenToOthers(folder));
}

std::string TutorSocketName(const std::string& learner) {
  std::string name;
  for (const char c : learner) {
    name += IsPlain(c) ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  if (name.size() > kLongestName) {
    name = name.substr(0, kLongestName - 17) + fmt::format("~{:016x}", DigestOf(learner));
  }
  return std::string(kBegin) + name + std::string(kEnd);
}

std::string LearnerOfSocket(const std::string& file_name) {
  const std::size_t around = kBegin.size() + kEnd.size();
  if (file_name.size() <= around || file_name.compare(0, kBegin.size(), kBegin) != 0 ||
      file_name.compare(file_name.size() - kEnd.size(), kEnd.size(), kEnd) != 0) {
    return {};
  }
  const std::string name = file_name.substr(kBegin.size(), file_name.size() - around);
  std::string learner;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const int high = i + 2 < name.size() && name[i] == '%' ? HexDigit(name[i + 1]) : -1;
    const int low = high >= 0 ? HexDigit(name[i + 2]) : -1;
    if (low >= 0) i += 2;
    learner += low >= 0 ? static_cast<char>(high * 16 + low) : name[i];
  }
  return learner;
}

bool PeerIsOwner(int fd) noexcept {
  ucred peer{};
  socklen_t size = sizeof peer;
  return getsockopt(fd, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 && size == sizeof peer &&
         IsOwner(peer, getuid());
}

TutorSocket::TutorSocket(const std::string& path) : path_(path), lock_path_(path + ".lock") {
  sockaddr_un address{};
  if (!LocalAddress(path_, address)) FailToOpen(path_, errno);
  lock_ = Lock(lock_path_);
  if (!lock_) throw LackError(say::SocketTaken(path_));
  struct stat found {};
  if (lstat(path_.c_str(), &found) == 0) {
    if (!S_ISSOCK(found.st_mode)) throw LackError(say::SocketIsNoSocket(path_));
    if (ConnectTo(path_)) throw LackError(say::SocketTaken(path_));
    if (unlink(path_.c_str()) != 0) FailToOpen(path_, errno);
  }
  FileDescriptor made(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!made) FailToOpen(path_, errno);
  // the folder keeps others out until the mode is right
  if (bind(made.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    FailToOpen(path_, errno);
  }
  if (chmod(path_.c_str(), 0600) != 0 || listen(made.get(), kAtOnce) != 0) {
    const int error = errno;
    unlink(path_.c_str());
    FailToOpen(path_, error);
  }
  listening_ = std::move(made);
}

TutorSocket::~TutorSocket() {
  if (!listening_) return;
  unlink(path_.c_str());
  unlink(lock_path_.c_str());  // while it is locked
}

std::vector<std::string> LearnersWithTutorSockets(const std::string& folder) {
  std::vector<std::string> learners;
  std::error_code error;
  std::filesystem::directory_iterator files(folder, error);
  if (error) return learners;
  RequireTutorFolder(folder);
  for (const auto& file : files) {
    const std::string learner = LearnerOfSocket(file.path().filename().string());
    if (!learner.empty() && IsLocked(file.path().string() + ".lock")) learners.push_back(learner);
  }
  std::sort(learners.begin(), learners.end());
  return learners;
}

}  // namespace moontrace
