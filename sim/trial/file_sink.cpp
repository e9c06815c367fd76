#include "sim/trial/file_sink.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "textures/base/error.h"
#include "textures/base/file_writing.h"

namespace moontrace {
namespace {
constexpr std::size_t kBufferBytes = std::size_t{256} * 1024;
}

FileSink::FileSink(std::string path) : path_(std::move(path)), buffer_(kBufferBytes) {
  do {
    file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (file_ < 0 && errno == EINTR);
  if (file_ < 0) Fail(errno);
}

FileSink::~FileSink() {
  if (file_ >= 0) ::close(file_);
}

void FileSink::Fail(int error) const {
  const bool full = error == ENOSPC || error == EDQUOT || error == EFBIG;
  throw LackError(fmt::format(
      "{}: {} ({}); {}", path_, full ? "no room to write" : "cannot be written",
      std::strerror(error),
      full ? "free some room or name another folder" : "check the folder and its permissions"));
}

void FileSink::Write(std::string_view bytes) {
  digest_.Add(bytes);
  while (!bytes.empty()) {
    const std::size_t taken = std::min(bytes.size(), buffer_.size() - used_);
    std::memcpy(buffer_.data() + used_, bytes.data(), taken);
    used_ += taken;
    bytes.remove_prefix(taken);
    if (used_ == buffer_.size()) Flush();
  }
}

void FileSink::Flush() {
  if (!WriteAll(file_, {buffer_.data(), used_})) Fail(errno);
  used_ = 0;
}

void FileSink::Close() {
  Flush();
  if (!SyncFile(file_)) Fail(errno);
  const int file = std::exchange(file_, -1);
  if (::close(file) != 0 && errno != EINTR) Fail(errno);
}

}  // namespace moontrace
