#pragma once

#include <deque>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "sim/console/line_editor.h"
#include "sim/console/raw_terminal.h"

namespace moontrace {

/// Lines that people type while something runs. Standard input is read only as far as it is there,
/// so that nothing blocks; its end is neither a line nor a wish to stop. Not for a stream that was
/// read in another manner before: what lies in the stream's own buffer is not seen here.
///
/// At a terminal it is a LineEditor that shows what is typed, since the terminal itself would print
/// what the arrow keys send.
class LineReader {
 public:
  explicit LineReader(std::istream& in);
  /// The next whole line without its end, waiting at most `milliseconds`; what is beyond
  /// 1000 bytes of a line is dropped.
  std::optional<std::string> Next(int milliseconds);

  /// No line will ever come again.
  bool ended() const { return ended_ && begun_.empty() && typed_.empty(); }
  /// A line has been given out.
  bool begun() const { return given_; }
  /// A person types at a terminal.
  bool at_terminal() const { return terminal_ != nullptr; }

 private:
  std::optional<std::string> Look(int milliseconds);
  std::optional<std::string> Whole();
  std::optional<std::string> TakeTyped();
  void TakeEarly();
  void Take(std::string_view bytes, bool early = false);

  std::istream& in_;
  bool standard_ = false;                  ///< `in` is the process's standard input
  std::unique_ptr<RawTerminal> terminal_;  ///< none: it is no terminal, or another job's
  LineEditor editor_;
  std::deque<std::string> typed_;  ///< at the terminal, and not yet given out
  bool ended_ = false, given_ = false;
  bool dropping_ = false;  ///< the rest of a line that was too long
  std::string begun_;      ///< read and not yet given out
};

}  // namespace moontrace
