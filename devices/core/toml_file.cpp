#include "devices/core/toml_file.h"

#include <fmt/core.h>

#include <cstddef>
#include <fstream>

#include "devices/core/device_error.h"

namespace moontrace {

std::string ReadTomlFile(const std::string& path, const char* whose) {
  constexpr std::size_t kMostBytes = 1 << 20;
  std::ifstream file(path, std::ios::binary);
  std::string text;
  if (file) {
    text.resize(kMostBytes + 1);
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
  }
  if (!file.is_open() || file.bad() || (text.empty() && !file.eof())) {
    throw DeviceError(fmt::format("{}: cannot be read: name {} TOML file", path, whose));
  }
  if (text.size() > kMostBytes) {
    throw DeviceError(fmt::format("{}: is longer than 1 MB: name {} TOML file", path, whose));
  }
  return text;
}

}  // namespace moontrace
