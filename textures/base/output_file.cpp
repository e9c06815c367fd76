#include "textures/base/output_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as the kernel follows

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

}  // namespace

void MakeFolder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw LackError(OneLine(folder, 300) + ": the folder cannot be made (" + error.message() +
                    "); name another place");
  }
}

OutputFile::OutputFile(const std::string& path)
    : path_(path), place_(TargetOf(path)), file_(std::fopen(partial().c_str(), "wb")) {
  if (file_ == nullptr) CannotWrite(path, std::strerror(errno));
}

OutputFile::~OutputFile() {
  if (file_ != nullptr) std::fclose(file_);
  if (!placed_) std::remove(partial().c_str());
}

void OutputFile::Append(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) Fail();
}

void OutputFile::Finish() {
  std::FILE* const file = std::exchange(file_, nullptr);
  if (std::fclose(file) != 0) Fail();
  if (std::rename(partial().c_str(), place_.c_str()) != 0) Fail();
  placed_ = true;
}

void OutputFile::Fail() const { CannotWrite(path_, std::strerror(errno)); }

void RequireWritable(const std::string& path) { const OutputFile tried(path); }

void WriteWhole(const std::string& path, const std::string& bytes) {
  OutputFile file(path);
  file.Append(bytes);
  file.Finish();
}

}  // namespace moontrace
