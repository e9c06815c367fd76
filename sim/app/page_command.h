#pragma once

#include <string>

#include "sim/setup/options.h"

namespace moontrace {

/// `page`: what stands on the page and what was replaced; a picture if asked for.
struct PageOptions {
  OutputOptions output;
  TextOptions text;
  StyleOptions style;
  LayoutOptions layout;
  std::string picture;
  bool letters = false;
  bool read_back = false;
};
void AddOptions(CLI::App& app, PageOptions& options);
int Run(const PageOptions& options, Console& console);

}  // namespace moontrace
