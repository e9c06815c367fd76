#pragma once

#include <cstddef>
#include <string>

#include "sim/picture/drawing.h"
#include "sim/picture/raster.h"
#include "sim/setup/cli_app.h"

namespace moontrace {

/// Whether the path ends in .svg, .png or .pdf (capitals too).
bool HasPictureEnding(const std::string& path);

/// Throws before any work is done: InputError for an ending other than .svg, .png, .pdf (capitals
/// too); LackError for a kind this build cannot write, a folder that is not there, a place that
/// cannot be written.
void CheckPicturePath(const std::string& path);

/// Writes the drawing in the kind that the path's ending names. First to a sibling, then renamed:
/// nothing half-written is left. Throws like CheckPicturePath, and LackError for a full disk.
void WritePicture(const std::string& path, const Drawing& drawing);

/// The same for a picture of points, which is a PNG whatever else the ending says: InputError.
void WritePicture(const std::string& path, const Raster& raster);

/// The picture's path for page `page` (from 0) of `pages`: F.svg as it is for a single page,
/// otherwise F-1.svg, F-2.svg ...
std::string PicturePath(const std::string& path, std::size_t page, std::size_t pages);

/// `--picture`; a path without an ending of pictures is a UsageError.
void AddPicture(CLI::App& app, std::string& path, const std::string& description);

}  // namespace moontrace
