#include "textures/base/text_pipe.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include "textures/base/error.h"

namespace moontrace {

void RequireRegularFile(const std::string& path) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status) || std::filesystem::is_directory(status)) return;
  if (!std::filesystem::is_regular_file(status)) {
    throw InputError(path + ": is no regular file; name one, not a pipe or a device");
  }
}

std::string ReadTextOrPipe(const std::string& path, std::size_t max_bytes) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw InputError(path + ": is a folder; name a file in it");
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             std::fclose);
  if (file == nullptr) {
    throw InputError(path + ": cannot be opened (" + std::strerror(errno) + "): check the path");
  }
  std::string text;
  char block[65536];
  for (;;) {
    const std::size_t count = std::fread(block, 1, sizeof block, file.get());
    text.append(block, count);
    if (text.size() > max_bytes) {
      throw InputError(path + ": holds more than " + std::to_string(max_bytes) +
                       " bytes; split it or name another file");
    }
    if (count < sizeof block) break;
  }
  if (std::ferror(file.get()) != 0) {
    throw InputError(path + ": cannot be read (" + std::strerror(errno) +
                     "); check the file and the permissions");
  }
  return text;
}

}  // namespace moontrace
