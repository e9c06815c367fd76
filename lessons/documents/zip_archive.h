#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace moontrace {

/// A zip archive that is read entry by entry, nothing of it ever written to a disk. Names are paths
/// with "/". All throw InputError (one line: the archive's name, cause), and LackError in a build
/// without libzip.
class ZipArchive {
 public:
  /// Opens a file. `most_bytes` is what all entries that are read may unpack to together.
  ZipArchive(const std::string& path, std::size_t most_bytes);
  /// The same of bytes; `name` stands in messages.
  ZipArchive(std::string bytes, const std::string& name, std::size_t most_bytes);
  ~ZipArchive();
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;

  bool Has(std::string_view entry) const;
  /// Nothing where there is no such entry, or where it has a password.
  std::optional<std::string> Read(std::string_view entry);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Whether this build can open them (libzip).
bool CanReadZip();

}  // namespace moontrace
