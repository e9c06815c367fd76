#include "textures/base/file_descriptor.h"

#include <sys/socket.h>

#include <cerrno>
#include <cstring>

namespace moontrace {

bool LocalAddress(const std::string& path, sockaddr_un& address) {
  address = {};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) {
    errno = ENAMETOOLONG;
    return false;
  }
  std::memcpy(address.sun_path, path.data(), path.size());
  return true;
}

FileDescriptor ConnectTo(const std::string& path) {
  sockaddr_un address{};
  if (!LocalAddress(path, address)) return FileDescriptor();
  FileDescriptor made(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!made) return made;
  if (connect(made.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    const int error = errno;
    made.Close();
    errno = error;
  }
  return made;
}

}  // namespace moontrace
