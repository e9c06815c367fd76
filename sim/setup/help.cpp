#include "sim/setup/help.h"

#include <fmt/core.h>

#include <CLI/App.hpp>

namespace moontrace {

CommandSheet SheetOf(const CLI::App& app) {
  CommandSheet sheet{app.get_name(), app.get_description(), {}};
  for (const CLI::Option* option : app.get_options()) {
    OptionSheet line;
    line.positional = option->get_positional();
    line.name = option->get_name(line.positional);
    if (!line.positional && option->get_expected_max() > 0) line.value = option->get_type_name();
    line.group = option->get_group();
    line.description = option->get_description();
    sheet.options.push_back(line);
  }
  return sheet;
}

}  // namespace moontrace
