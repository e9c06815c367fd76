#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace moontrace {

/// A place in a text: line and column, both from 1; columns count bytes.
struct TextPlace {
  std::size_t line = 1;
  std::size_t column = 1;
};

/// Place of a byte offset (held to the text's end).
TextPlace PlaceOf(std::string_view text, std::size_t offset);

/// Control characters made visible ("?"), long texts cut to `limit` bytes between characters, so
/// that foreign text can stand in a one-line message.
std::string OneLine(std::string_view text, std::size_t limit = 60);

/// Characters (code points, not bytes) of UTF-8, however it is broken.
std::size_t CountCharacters(std::string_view utf8) noexcept;

/// A to Z in lower case, for words and file endings in which case does not matter.
std::string LowerCase(std::string_view text);

/// Throws InputError (file:line:column, the encoding where a byte order mark shows it, cure) unless
/// the bytes are UTF-8.
void RequireUtf8(std::string_view bytes, const std::string& file_name);

/// Reads a whole file. Throws InputError (path, cause, cure): missing, a folder, unreadable, more
/// than `max_bytes`.
std::string ReadTextFile(const std::string& path, std::size_t max_bytes);

/// Throws InputError unless a file is a regular one (through links too): a pipe or a device node
/// could be waited for without end. One that is missing passes: opening it says so.
void RequireRegularFile(const std::string& path);

/// As ReadTextFile, but also what comes out of a pipe, where someone named one in place of a file;
/// waits until its writer ends it.
std::string ReadTextOrPipe(const std::string& path, std::size_t max_bytes);

}  // namespace moontrace
