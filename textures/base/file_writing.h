#pragma once

#include <string>
#include <string_view>

namespace moontrace {

/// What has to be done so that bytes are still there after a power cut. All return false with the
/// reason in errno, and go on where a signal interrupted them.

/// Writes all bytes to an open file, in several writes where one takes a part.
[[nodiscard]] bool WriteAll(int file, std::string_view bytes) noexcept;

/// Returns once the disk has what was written to an open file or folder. True, too, on file systems
/// that know no such order: there nothing better can be had.
[[nodiscard]] bool SyncFile(int file) noexcept;

/// Returns once the disk has the names that were made, changed or removed in a folder (empty: the
/// present one). True, too, for a folder that may not be read: it cannot be opened for this.
[[nodiscard]] bool SyncFolder(const std::string& folder) noexcept;

/// The folder that holds the name of `path`, as SyncFolder takes it.
std::string FolderOf(const std::string& path);

}  // namespace moontrace
