#pragma once

namespace moontrace {

/// Standard input gives each key at once and echoes nothing, for as long as this lives. Everything
/// else of the terminal stays; nothing is written to it. It is as it was before on every way out:
/// the destructor, a second signal that ends the process at once, a stop by Ctrl-Z (and raw again
/// when it goes on), a crash. One at a time.
class RawTerminal {
 public:
  /// Throws LackError: no terminal.
  RawTerminal();
  ~RawTerminal();
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;
};

}  // namespace moontrace
