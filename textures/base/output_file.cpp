#include "textures/base/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "textures/base/error.h"
#include "textures/base/file_writing.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as the kernel follows
constexpr std::size_t kBufferBytes = std::size_t{64} * 1024;

[[noreturn]] void CannotWrite(const std::string& path, const std::string& cause) {
  throw LackError(OneLine(path, 300) + ": cannot be written (" + cause + "); choose another place");
}

/// Where the bytes finally go: renaming onto a link or a device would replace it by a file.
std::string TargetOf(const std::string& path) {
  if (path == "-") CannotWrite(path, "it stands for standard input");
  std::error_code ignored;
  fs::path place = path;
  for (int links = 0; fs::is_symlink(place, ignored); ++links) {
    if (links == kMostLinks) CannotWrite(path, "its links go round in a circle");
    place = place.parent_path() / fs::read_symlink(place, ignored);
  }
  const fs::file_status status = fs::status(place, ignored);
  if (fs::is_directory(status)) CannotWrite(path, "it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    CannotWrite(path, "it is a pipe or a device");
  }
  return place.string();
}

[[noreturn]] void CannotMake(const std::string& folder, int error) {
  throw LackError(OneLine(folder, 300) + ": the folder cannot be made (" + std::strerror(error) +
                  "); name another place");
}

void MakeMissing(const fs::path& folder, const std::string& asked) {
  std::error_code ignored;
  if (folder.empty() || fs::is_directory(folder, ignored)) return;
  MakeMissing(folder.parent_path(), asked);
  constexpr mode_t kAll = 0777;  // less what the user's mask takes away
  if (::mkdir(folder.c_str(), kAll) != 0) {
    const int error = errno;
    if (!fs::is_directory(folder, ignored)) CannotMake(asked, error);
  }
  if (!SyncFolder(folder.parent_path().string())) CannotMake(asked, errno);
}

}  // namespace

void MakeFolder(const std::string& folder) {
  if (folder.empty()) CannotMake(folder, ENOENT);
  const fs::path path = fs::path(folder).lexically_normal();
  MakeMissing(path.has_filename() ? path : path.parent_path(), folder);
}

OutputFile::OutputFile(const std::string& path, bool lasting)
    : path_(path), place_(TargetOf(path)), lasting_(lasting) {
  constexpr mode_t kReadWrite = 0666;
  do {
    file_ = FileDescriptor(
        ::open(partial().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kReadWrite));
  } while (!file_ && errno == EINTR);
  if (!file_) CannotWrite(path, std::strerror(errno));
}

OutputFile::~OutputFile() {
  if (!placed_) std::remove(partial().c_str());
}

void OutputFile::Append(std::string_view bytes) {
  if (buffer_.size() + bytes.size() >= kBufferBytes) Flush();
  if (bytes.size() < kBufferBytes) {
    buffer_ += bytes;
  } else if (!WriteAll(file_.get(), bytes)) {
    Fail();
  }
}

void OutputFile::Flush() {
  if (!WriteAll(file_.get(), buffer_)) Fail();
  buffer_.clear();
}

void OutputFile::Finish() {
  Flush();
  if (lasting_ && !SyncFile(file_.get())) Fail();
  file_.Close();
  if (std::rename(partial().c_str(), place_.c_str()) != 0) Fail();
  placed_ = true;
  if (lasting_ && !SyncFolder(FolderOf(place_))) Fail();
}

void OutputFile::Fail() const { CannotWrite(path_, std::strerror(errno)); }

void RequireWritable(const std::string& path) { const OutputFile tried(path); }

void WriteWhole(const std::string& path, const std::string& bytes, bool lasting) {
  OutputFile file(path, lasting);
  file.Append(bytes);
  file.Finish();
}

}  // namespace moontrace
