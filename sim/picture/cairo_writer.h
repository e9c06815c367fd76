#pragma once

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

/// The drawing as a one-page PDF in its true size, with title and description as document
/// properties. Throws LackError where the build has no cairo.
std::string ToPdf(const Drawing& drawing);

}  // namespace moontrace
