#pragma once

#include <string>

#include "sim/setup/options.h"
#include "sim/wording/console.h"

namespace moontrace {

/// `moontrace sounds`: learn the sounds. One line each; played or written if asked for.
struct SoundsOptions {
  bool play = false;
  std::string wav;     ///< folder; empty: none are written
  std::string sounds;  ///< a file of the user's, see LoadSounds
  OutputOptions output;
};

void AddOptions(CLI::App& app, SoundsOptions& options);
/// Throws LackError where `play` finds no output; the list has been given then.
int Run(const SoundsOptions& options, Console& console);

}  // namespace moontrace
