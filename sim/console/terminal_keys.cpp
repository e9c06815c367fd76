#include "sim/console/terminal_keys.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "textures/base/text_file.h"

namespace moontrace {

namespace {

/// What follows "ESC [" or "ESC O", as xterm, the Linux console and VT220 send it.
constexpr std::array<std::pair<std::string_view, std::string_view>, 35> kSequences = {{
    {"A", "Up"},      {"B", "Down"},      {"C", "Right"}, {"D", "Left"},  {"H", "Home"},
    {"F", "End"},     {"1~", "Home"},     {"4~", "End"},  {"7~", "Home"}, {"8~", "End"},
    {"5~", "PageUp"}, {"6~", "PageDown"}, {"P", "F1"},    {"Q", "F2"},    {"R", "F3"},
    {"S", "F4"},      {"11~", "F1"},      {"12~", "F2"},  {"13~", "F3"},  {"14~", "F4"},
    {"[A", "F1"},     {"[B", "F2"},       {"[C", "F3"},   {"[D", "F4"},   {"[E", "F5"},
    {"15~", "F5"},    {"17~", "F6"},      {"18~", "F7"},  {"19~", "F8"},  {"20~", "F9"},
    {"21~", "F10"},   {"23~", "F11"},     {"24~", "F12"}, {"M", "Enter"}, {"I", "Tab"},
}};

/// Length of the sequence behind "ESC [" or "ESC O": up to its final byte.
std::size_t SequenceLength(std::string_view bytes) {
  std::size_t length = 0;
  if (!bytes.empty() && bytes[0] == '[') ++length;  // the Linux console's F1 to F5
  while (length < bytes.size() && (bytes[length] < '@' || bytes[length] > '~')) ++length;
  return std::min(length + 1, bytes.size());
}

std::string NameOfSequence(std::string_view sequence) {
  for (const auto& known : kSequences) {
    if (known.first == sequence) return std::string(known.second);
  }
  return {};
}

std::string NameOfControl(char byte) {
  switch (byte) {
    case ' ':
      return "Space";
    case '\r':
    case '\n':
      return "Enter";
    case '\t':
      return "Tab";
    case '\b':
    case '\x7f':
      return "Backspace";
    default:
      return {};
  }
}

/// Bytes of the character that begins with `first`; 0: none begins so.
std::size_t CharacterLength(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return 2;
  if (first >= 0xe0 && first < 0xf0) return 3;
  return first >= 0xf0 && first < 0xf5 ? 4 : 0;
}

}  // namespace

std::vector<std::string> ReadKeys(std::string_view bytes) {
  std::vector<std::string> keys;
  while (!bytes.empty()) {
    const char first = bytes[0];
    if (first == '\x1b') {
      bytes.remove_prefix(1);
      const bool sequence = bytes.size() > 1 && (bytes[0] == '[' || bytes[0] == 'O');
      if (!sequence) {
        keys.emplace_back("Escape");
        continue;
      }
      bytes.remove_prefix(1);
      const std::size_t length = SequenceLength(bytes);
      std::string name = NameOfSequence(bytes.substr(0, length));
      if (!name.empty()) keys.push_back(std::move(name));
      bytes.remove_prefix(length);
      continue;
    }
    const std::size_t length = CharacterLength(static_cast<unsigned char>(first));
    const bool printable =
        length > 0 && length <= bytes.size() && (length > 1 || (first > ' ' && first != '\x7f'));
    std::string name = printable ? std::string(bytes.substr(0, length)) : NameOfControl(first);
    const bool whole = std::all_of(name.begin() + (name.empty() ? 0 : 1), name.end(),
                                   [length](char c) { return length == 1 || (c & 0xc0) == 0x80; });
    if (!name.empty() && whole) keys.push_back(std::move(name));
    bytes.remove_prefix(printable && whole ? length : 1);
  }
  return keys;
}

bool IsKeyName(const std::string& name) {
  for (const char* special : {"Space", "Enter", "Tab", "Backspace", "Escape"}) {
    if (name == special) return true;
  }
  for (const auto& known : kSequences) {
    if (name == known.second) return true;
  }
  return CountCharacters(name) == 1 && static_cast<unsigned char>(name[0]) > ' ';
}

}  // namespace moontrace
