#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "sim/picture/drawing.h"
#include "sim/picture/raster.h"

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

/// A picture for each page of something: in one file if it is a PDF, otherwise F.svg for a single
/// page and F-1.svg, F-2.svg ... for several, 100 at most. Nothing half-written is left; of several
/// files those that are finished stay.
class PagePictures {
 public:
  /// Throws InputError for more files than 100, and like WritePicture.
  PagePictures(const std::string& path, std::size_t pages);
  ~PagePictures();
  /// The next page. Throws like WritePicture.
  void Add(const Drawing& page);
  /// The files that were written, once all pages are there. Throws like WritePicture.
  std::vector<std::string> Finish();

 private:
  struct Pdf;
  std::string path_;
  std::size_t pages_;
  std::vector<std::string> files_;
  std::unique_ptr<Pdf> pdf_;
};

/// The same for a picture of points, which is a PNG whatever else the ending says: InputError.
/// `lasting` as in OutputFile.
void WritePicture(const std::string& path, const Raster& raster, bool lasting = true);

}  // namespace moontrace
