#include "textures/base/text_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>

#include "textures/base/error.h"
#include "textures/base/utf8.h"

namespace moontrace {

TextPlace PlaceOf(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  TextPlace place;
  place.line = 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  const std::size_t newline = before.rfind('\n');
  place.column = newline == std::string_view::npos ? before.size() + 1 : before.size() - newline;
  return place;
}

std::string OneLine(std::string_view text, std::size_t limit) {
  std::string line(text.substr(0, limit));
  if (text.size() > limit) {
    // The cut must not leave half a UTF-8 character behind.
    std::size_t cut = limit;
    while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0U) == 0x80U) --cut;
    line.resize(cut);
    line += "...";
  }
  while (const std::optional<std::size_t> bad = FirstBadUtf8(line)) line[*bad] = '?';
  return HiddenShown(line);
}

std::size_t CountCharacters(std::string_view utf8) noexcept {
  return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

std::string LowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

void RequireUtf8(std::string_view bytes, const std::string& file_name) {
  const std::optional<std::size_t> bad = FirstBadUtf8(bytes);
  if (!bad) return;
  const std::string_view mark = bytes.substr(0, 2);
  const bool wide = mark == "\xFF\xFE" || mark == "\xFE\xFF";
  const TextPlace place = PlaceOf(bytes, *bad);
  throw InputError(file_name + ":" + std::to_string(place.line) + ":" +
                   std::to_string(place.column) + ": " +
                   (wide ? "this is UTF-16" : "this is not UTF-8") + "; save it as UTF-8");
}

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

std::string ReadTextFile(const std::string& path, std::size_t max_bytes) {
  RequireRegularFile(path);
  return ReadTextOrPipe(path, max_bytes);
}

}  // namespace moontrace
