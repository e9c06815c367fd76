#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/console/console.h"
#include "sim/console/line_reader.h"
#include "sim/console/raw_terminal.h"
#include "sim/console/terminal_keys.h"
#include "sim/learn/learn_input.h"

namespace moontrace {

/// Key (ReadKeys) -> word of learn_words.h.
using KeyMap = std::map<std::string, std::string>;

/// Escape stop, Space pause, ? and F1 help, r again, w where, + bigger, - smaller, ] more help, [
/// less help, n next, q quit, and others.
KeyMap UsualKeys();
/// The usual keys changed by a TOML file: `again = "x"`, one key a word. Throws InputError:
/// file:line:column, cause, nearest word; with all keys that two words would have. Escape always
/// stops.
KeyMap LoadKeys(const std::string& path);
/// The same of a file's text. `name` stands in messages.
KeyMap ParseKeys(std::string_view text, const std::string& name);

/// Keys made lines, without a terminal. While an answer is awaited, signs gather until Enter. Who
/// types "stop" stops, though each of its letters has been a key.
class KeyLines {
 public:
  explicit KeyLines(KeyMap keys) : keys_(std::move(keys)) {}
  struct Result {
    std::string echo;                 ///< to be written as it is
    std::optional<std::string> line;  ///< as if typed with Enter
  };
  Result Take(const std::string& key, bool asked);

 private:
  KeyMap keys_;
  std::string begun_;
  std::string typed_;  ///< the last keys that were letters
};

/// Single keys of the terminal.
class KeyInput final : public LearnInput {
 public:
  /// Throws LackError: standard input is no terminal.
  KeyInput(KeyMap keys, Console& console);
  std::optional<std::string> Next(int milliseconds, bool asked) override;
  bool ended() const override { return ended_ && waiting_.empty(); }

 private:
  RawTerminal terminal_;
  KeyLines lines_;
  Console& console_;
  std::vector<std::string> waiting_;  ///< keys not yet taken, the next one last
  bool ended_ = false;
};

/// Single keys, where they are given, otherwise lines that are typed with Enter. Throws LackError
/// as KeyInput. `lines` and `console` must outlive it. `name`: of the learner, which may come first
/// in a pipe also where it need not be asked, and is no word then; empty: nobody's.
std::unique_ptr<LearnInput> InputFor(const std::optional<KeyMap>& keys, LineReader& lines,
                                     const std::string& name, Console& console);

}  // namespace moontrace
