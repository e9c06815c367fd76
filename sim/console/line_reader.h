#pragma once

#include <iosfwd>
#include <optional>
#include <string>

namespace moontrace {

/// Lines that people type while something runs. Standard input is read only as far as it is there,
/// so that nothing blocks; its end is neither a line nor a wish to stop. Not for a stream that was
/// read in another manner before: what lies in the stream's own buffer is not seen here.
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
