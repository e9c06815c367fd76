#pragma once

#include <sys/un.h>
#include <unistd.h>

#include <string>
#include <utility>

namespace moontrace {

/// Owns an open file of the system; -1 is none.
class FileDescriptor {
 public:
  explicit FileDescriptor(int fd = -1) noexcept : fd_(fd) {}
  FileDescriptor(FileDescriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~FileDescriptor() { Close(); }
  void Close() noexcept {
    if (fd_ >= 0) close(std::exchange(fd_, -1));
  }

  int get() const noexcept { return fd_; }
  explicit operator bool() const noexcept { return fd_ >= 0; }

 private:
  int fd_;
};

/// The address of a local socket. False, with the reason in errno, for a path that is too long.
bool LocalAddress(const std::string& path, sockaddr_un& address);

/// Connects to a local socket; none, with the reason in errno, if nobody listens. Does not block.
FileDescriptor ConnectTo(const std::string& path);

}  // namespace moontrace
