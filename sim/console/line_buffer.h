#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace moontrace {

/// Cuts a stream of bytes into lines. A line longer than `longest` is dropped whole, so that memory
/// stays bounded whatever is sent.
class LineBuffer {
 public:
  explicit LineBuffer(std::size_t longest) : longest_(longest) {}

  void Feed(std::string_view bytes);
  /// The next whole line, without its end ("\n" or "\r\n").
  std::optional<std::string> Next();
  /// Whole lines that Next would give.
  bool empty() const { return begun_.find('\n') == std::string::npos; }
  /// Whether a line was too long since the last call.
  bool TakeDropped();

 private:
  std::size_t longest_;
  std::string begun_;
  bool dropping_ = false;  ///< until the end of a line that was too long
  bool dropped_ = false;
};

}  // namespace moontrace
