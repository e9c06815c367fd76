#include "sim/app/output_files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "sim/app/messages.h"
#include "textures/error.h"

namespace moontrace {

void MakeFolder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw LackError(say::CannotMakeFolder(folder, error.message()));
}

void WriteWhole(const std::string& path, const std::string& bytes) {
  const std::string partial = path + ".partial";
  std::FILE* file = std::fopen(partial.c_str(), "wb");
  if (file == nullptr) throw LackError(say::CannotWriteFile(path, std::strerror(errno)));
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const bool closed = std::fclose(file) == 0;
  if (!written || !closed || std::rename(partial.c_str(), path.c_str()) != 0) {
    const std::string cause = std::strerror(errno);
    std::remove(partial.c_str());
    throw LackError(say::CannotWriteFile(path, cause));
  }
}

}  // namespace moontrace
