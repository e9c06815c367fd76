#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// Makes lines of what is typed at a terminal that gives each key at once. Pure: what is to be seen
/// of it is given back, and holds no escape sequence.
///
/// Backspace, Ctrl-W and Ctrl-U take away a character, a word, all; Up and Down bring earlier lines
/// back; Ctrl-D on an empty line is the end of input. All other keys without a sign do nothing.
class LineEditor {
 public:
  /// `longest`: bytes of a line; what is typed beyond is left out.
  explicit LineEditor(std::size_t longest) : longest_(longest) {}

  struct Typed {
    std::string echo;                ///< to be written to the terminal as it is
    std::vector<std::string> lines;  ///< without their ends
    bool ended = false;              ///< no more will come
  };
  /// `early`: typed before the program had the terminal, when Ctrl-D came as a zero; later a zero
  /// is Ctrl-@, and does nothing.
  Typed Take(std::string_view bytes, bool early = false);
  /// What was held back, in hope of the rest of a key's sequence, was a key of its own: it does
  /// nothing. To be said where nothing has followed for a while.
  void ForgetBegun();
  /// Something is held back.
  bool holds() const { return !held_.empty(); }

 private:
  void TakeKey(const std::string& key, Typed& typed);
  void TakeControl(char byte, bool early, Typed& typed);
  void Replace(std::string line, Typed& typed);
  void Recall(bool earlier, Typed& typed);

  std::size_t longest_;
  std::string line_, held_;
  std::vector<std::string> before_;  ///< lines that were typed
  std::size_t at_ = 0;               ///< of `before_`, or its size: a line of now
  std::string now_;                  ///< what was begun before earlier lines were looked at
};

}  // namespace moontrace
