#include "sim/console/line_editor.h"

#include <algorithm>
#include <utility>

#include "sim/console/terminal_keys.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

// what Ctrl-D becomes that was typed before the program had the terminal
constexpr char kEarlyCtrlD = '\0';
constexpr char kCtrlD = '\x04', kCtrlU = '\x15', kCtrlW = '\x17', kEscape = '\x1b';
constexpr std::string_view kControls("\0\x04\x15\x17", 4);
constexpr std::size_t kMostBefore = 100;

/// Bytes at the end that may be the beginning of a key: an escape sequence or a character of UTF-8.
std::size_t Unfinished(std::string_view bytes) {
  constexpr std::size_t kLongestSequence = 16;
  const std::size_t escape = bytes.rfind(kEscape);
  if (escape != std::string_view::npos && bytes.size() - escape <= kLongestSequence) {
    const std::string_view behind = bytes.substr(escape + 1);
    const bool begins = behind.empty() || behind[0] == '[' || behind[0] == 'O';
    const auto is_final = [](char c) { return c >= '@' && c <= '~'; };
    const bool linux_console = behind.size() > 1 && behind[1] == '[';  // its F1 to F5
    const std::size_t parameters = linux_console ? 2 : std::min<std::size_t>(1, behind.size());
    const std::string_view rest = behind.substr(parameters);
    if (begins && std::none_of(rest.begin(), rest.end(), is_final)) return bytes.size() - escape;
  }
  for (std::size_t length = 1; length <= std::min<std::size_t>(3, bytes.size()); ++length) {
    const auto byte = static_cast<unsigned char>(bytes[bytes.size() - length]);
    if ((byte & 0xc0U) == 0x80U) continue;
    const std::size_t whole = byte >= 0xf0U ? 4 : byte >= 0xe0U ? 3 : byte >= 0xc0U ? 2 : 1;
    return whole > length ? length : 0;
  }
  return 0;
}

/// Of what is at the line's end; a character takes one column.
void Erase(std::string_view text, std::string& echo) {
  for (std::size_t i = CountCharacters(text); i > 0; --i) echo += "\b \b";
}

}  // namespace

LineEditor::Typed LineEditor::Take(std::string_view bytes, bool early) {
  Typed typed;
  const std::string all = std::exchange(held_, {}) + std::string(bytes);
  std::string_view rest = all;
  held_ = rest.substr(rest.size() - Unfinished(rest));
  rest.remove_suffix(held_.size());
  while (!rest.empty()) {
    const std::size_t control = std::min(rest.find_first_of(kControls), rest.size());
    for (const std::string& key : ReadKeys(rest.substr(0, control))) TakeKey(key, typed);
    if (control < rest.size()) TakeControl(rest[control], early, typed);
    rest.remove_prefix(std::min(control + 1, rest.size()));
  }
  return typed;
}

void LineEditor::ForgetBegun() { held_.clear(); }

void LineEditor::Replace(std::string line, Typed& typed) {
  Erase(line_, typed.echo);
  typed.echo += line;
  line_ = std::move(line);
}

void LineEditor::Recall(bool earlier, Typed& typed) {
  if (earlier ? at_ == 0 : at_ == before_.size()) return;
  if (at_ == before_.size()) now_ = line_;
  earlier ? --at_ : ++at_;
  Replace(at_ == before_.size() ? now_ : before_[at_], typed);
}

void LineEditor::TakeControl(char byte, bool early, Typed& typed) {
  const bool ends = byte == kCtrlD || (early && byte == kEarlyCtrlD);
  if (ends && line_.empty()) typed.ended = true;
  if (byte == kCtrlU) Replace({}, typed);
  if (byte != kCtrlW) return;
  const std::size_t end = line_.find_last_not_of(' ') + 1;
  const std::size_t blank = line_.substr(0, end).rfind(' ');
  Replace(line_.substr(0, blank == std::string::npos ? 0 : blank + 1), typed);
}

void LineEditor::TakeKey(const std::string& key, Typed& typed) {
  if (key == "Enter") {
    typed.echo += '\n';
    const bool fresh = !line_.empty() && (before_.empty() || before_.back() != line_);
    if (fresh) before_.push_back(line_);
    if (before_.size() > kMostBefore) before_.erase(before_.begin());
    at_ = before_.size();
    typed.lines.push_back(std::exchange(line_, {}));
  } else if (key == "Backspace") {
    std::string shorter = line_;
    while (!shorter.empty() && (static_cast<unsigned char>(shorter.back()) & 0xc0U) == 0x80U) {
      shorter.pop_back();
    }
    if (!shorter.empty()) shorter.pop_back();
    Erase(std::string_view(line_).substr(shorter.size()), typed.echo);
    line_ = std::move(shorter);
  } else if (key == "Up" || key == "Down") {
    Recall(key == "Up", typed);
  } else if (key == "Space" || CountCharacters(key) == 1) {
    const std::string sign = key == "Space" ? " " : key;
    if (line_.size() + sign.size() > longest_) return;
    line_ += sign;
    typed.echo += sign;
  }
}

}  // namespace moontrace
