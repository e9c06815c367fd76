#pragma once

#include <memory>

namespace moontrace {

/// Standard input gives each key at once and echoes nothing, for as long as this lives. Everything
/// else of the terminal stays; nothing is written to it. It is as it was before on every way out:
/// the destructor, a second signal that ends the process at once, a stop by Ctrl-Z (and raw again
/// when it goes on), a crash; a process beside gives it back where this one is killed. Several are
/// as one: the last that ends gives the terminal back. One thread.
class RawTerminal {
 public:
  /// Throws LackError: no terminal.
  RawTerminal();
  ~RawTerminal();
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;
};

/// None where standard input is no terminal, or one that another job has: to change that one's
/// settings would stop this process.
std::unique_ptr<RawTerminal> RawTerminalIfOurs();

}  // namespace moontrace
