#pragma once

#include <string>

#include "sim/setup/options.h"

namespace moontrace {

/// `gallery`: a picture of each script and option with words beside it, in one page of HTML. The
/// pictures and words are those of the command that stands above them.
struct GalleryOptions {
  OutputOptions output;
  std::string folder = "moontrace-gallery";
};
void AddOptions(CLI::App& app, GalleryOptions& options);
int Run(const GalleryOptions& options, Console& console);

}  // namespace moontrace
