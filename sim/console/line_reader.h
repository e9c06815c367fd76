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
  /// The next whole line without its end, waiting at most `milliseconds`; what is beyond
  /// 1000 bytes of a line is dropped.
  std::optional<std::string> Next(int milliseconds);

  /// No line will ever come again.
  bool ended() const { return ended_ && begun_.empty(); }

 private:
  std::optional<std::string> Whole();
  std::istream& in_;
  bool terminal_ = false;  ///< `in` is the process's standard input
  bool ended_ = false;
  bool dropping_ = false;  ///< the rest of a line that was too long
  std::string begun_;      ///< read and not yet given out
};

}  // namespace moontrace
