#include "sim/setup/help.h"

#include <fmt/core.h>

#include <CLI/App.hpp>

#include "sim/console/console.h"
#include "sim/console/line_wrap.h"

namespace moontrace {

std::string HelpText(const CLI::App& app) {
  std::string usage = fmt::format("Usage: moontrace {}", app.get_name());
  std::string lines;
  for (const CLI::Option* option : app.get_options()) {
    const bool positional = option->get_positional();
    std::string name = option->get_name(positional);
    if (positional) usage += fmt::format(" [{}]", name);
    if (!positional && option->get_expected_max() > 0)
      name = fmt::format("{} {}", name, option->get_type_name());
    lines += Wrapped(fmt::format("{}: {}", name, option->get_description()));
  }
  return Wrapped(fmt::format("moontrace {}: {}.", app.get_name(), app.get_description())) +
         Wrapped(fmt::format("{} [options]", usage)) + lines;
}

}  // namespace moontrace
