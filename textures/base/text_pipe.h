#pragma once

#include <cstddef>
#include <string>

namespace moontrace {

/// Throws InputError unless a file is a regular one (through links too): a pipe or a device node
/// could be waited for without end. One that is missing passes: opening it says so.
void RequireRegularFile(const std::string& path);

/// As ReadTextFile, but also what comes out of a pipe, where someone named one in place of a file;
/// waits until its writer ends it.
std::string ReadTextOrPipe(const std::string& path, std::size_t max_bytes);

}  // namespace moontrace
