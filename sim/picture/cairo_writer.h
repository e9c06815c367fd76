#pragma once

#include <memory>
#include <string>

#include "sim/picture/drawing.h"
#include "sim/picture/raster.h"

namespace moontrace {

/// Whether this build can write PNG and PDF.
bool HaveCairo() noexcept;

/// The drawing as a PNG at 300 dots per inch, fewer where the longer side would pass 4000 dots.
/// Throws LackError where the build has no cairo.
std::string ToPng(const Drawing& drawing);

/// A picture of points as a PNG. Throws LackError where the build has no cairo.
std::string ToPng(const Raster& raster);

/// A PDF, page by page, each in its true size; title and description of the first are the
/// document's. Throws LackError where the build has no cairo, or a page cannot be drawn.
class PdfWriter {
 public:
  PdfWriter();
  ~PdfWriter();
  void Add(const Drawing& page);
  /// The bytes that were made since the last call: a book's are never all held. None is missing
  /// after Finish.
  std::string Take();
  void Finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace moontrace
