#pragma once

#include <iosfwd>
#include <optional>
#include <string>

namespace moontrace {

/// Lines that people type while something runs. Of standard input only what is there is read, so
/// that nobody waits; the end of input is no line and no end. Input that was begun otherwise must
/// not be read on here.
class LineReader {
 public:
  explicit LineReader(std::istream& in);
  /// The next whole line without its end, waiting at most `milliseconds`; lines are cut at 1000
  /// bytes.
  std::optional<std::string> Next(int milliseconds);

 private:
  std::optional<std::string> Whole();
  std::istream& in_;
  bool terminal_ = false;  ///< `in` is the process's standard input
  bool ended_ = false;
  std::string begun_;  ///< read and not yet given out
};

}  // namespace moontrace
