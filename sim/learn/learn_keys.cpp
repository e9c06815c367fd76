#include "sim/learn/learn_keys.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ostream>
#include <utility>

#include "sim/learn/learn_messages.h"
#include "sim/learn/learn_words.h"
#include "textures/base/text_file.h"
#include "textures/base/toml_reader.h"
#include "textures/base/utf8.h"

namespace moontrace {

namespace {

/// Word -> its key; F1 for help comes beside.
std::vector<std::pair<std::string, std::string>> UsualWords() {
  return {{"again", "r"},     {"next", "n"},      {"back", "p"},      {"where", "w"},
          {"letter", "l"},    {"spell", "s"},     {"word", "o"},      {"bigger", "+"},
          {"smaller", "-"},   {"more help", "]"}, {"less help", "["}, {"slower", ","},
          {"faster", "."},    {"hint", "h"},      {"stop", "Escape"}, {"go", "g"},
          {"pause", "Space"}, {"skip", "k"},      {"lessons", "e"},   {"how am i doing", "i"},
          {"brief", "b"},     {"full", "f"},      {"my text", "m"},   {"done", "d"},
          {"quit", "q"},      {"help", "?"}};
}

}  // namespace

KeyMap UsualKeys() {
  KeyMap keys{{"F1", "help"}};
  for (const auto& [word, key] : UsualWords()) keys[key] = word;
  return keys;
}

namespace {

KeyMap KeysOf(const TomlTable& table) {
  KeyMap keys;
  std::vector<std::string> conflicts;
  std::string place;
  for (const auto& [word, usual] : UsualWords()) {
    const std::string key = table.String(word, usual);
    if (!IsKeyName(key)) table.Fail(word, say::NoSuchKey(key));
    if (word == "stop" && key != "Escape") table.Fail(word, say::EscapeStops());
    const auto taken = keys.emplace(key, word);
    if (taken.second) continue;
    conflicts.push_back(say::TwoWordsOneKey(key, taken.first->second, word));
    if (place.empty()) place = table.Has(word) ? word : taken.first->second;
  }
  table.FailUnknown();
  if (!conflicts.empty()) table.Fail(place, say::KeyConflicts(conflicts));
  keys.emplace("F1", "help");
  return keys;
}

}  // namespace

KeyMap LoadKeys(const std::string& path) { return KeysOf(TomlTable::Read(path)); }

KeyMap ParseKeys(std::string_view text, const std::string& name) {
  return KeysOf(TomlTable::Parse(text, name));
}

KeyLines::Result KeyLines::Take(const std::string& key, bool asked) {
  const auto word = keys_.find(key);
  const bool stops = word != keys_.end() && word->second == "stop";
  if (stops) return {std::exchange(begun_, {}).empty() ? "" : "\n", "/stop"};
  const bool sign = key.size() == 1 || static_cast<unsigned char>(key[0]) >= 0x80;
  constexpr std::string_view kStop = "stop";
  typed_ = sign ? typed_ + LowerCase(key) : std::string();
  if (typed_.size() > kStop.size()) typed_.erase(0, typed_.size() - kStop.size());
  if (begun_.empty() && !asked && typed_ == kStop) return {"", "/stop"};
  if ((asked && (sign || (key == "Space" && !begun_.empty()))) || !begun_.empty()) {
    if (key == "Enter") return {"\n", std::exchange(begun_, {})};
    if (key == "Backspace") {
      // nothing is overwritten: what is left stands on a line of its own
      while (!begun_.empty() && (begun_.back() & 0xc0) == 0x80) begun_.pop_back();
      if (!begun_.empty()) begun_.pop_back();
      return {"\n" + begun_, std::nullopt};
    }
    const std::string typed = key == "Space" ? " " : sign ? key : "";
    constexpr std::size_t kLongest = 70;
    if (begun_.size() + typed.size() > kLongest) return {};
    begun_ += typed;
    return {typed, std::nullopt};
  }
  if (key == "Enter") return {"", ""};
  if (word != keys_.end()) return {"", "/" + word->second};
  return {"", "/" + key};  // answered as an unknown word is
}

KeyInput::KeyInput(KeyMap keys, Console& console) : lines_(std::move(keys)), console_(console) {}

std::optional<std::string> KeyInput::Next(int milliseconds, bool asked) {
  if (waiting_.empty() && !ended_) {
    pollfd wait{STDIN_FILENO, POLLIN, 0};
    if (poll(&wait, 1, milliseconds) <= 0) return std::nullopt;
    char block[256];
    const ssize_t count = read(STDIN_FILENO, block, sizeof block);
    if (count <= 0) {
      ended_ = count == 0 || errno != EINTR;
      return std::nullopt;
    }
    waiting_ = ReadKeys({block, static_cast<std::size_t>(count)});
    // Ctrl-D at the beginning of a line is the end of input elsewhere, so it is here
    if (count == 1 && block[0] == '\x04') ended_ = true;
    std::reverse(waiting_.begin(), waiting_.end());
  }
  while (!waiting_.empty()) {
    const std::string key = waiting_.back();
    waiting_.pop_back();
    KeyLines::Result result = lines_.Take(key, asked);
    console_.out() << result.echo;
    console_.out().flush();
    if (result.line) return result.line;
  }
  return std::nullopt;
}

namespace {

/// Lines that are typed with Enter.
class TypedLines final : public LearnInput {
 public:
  TypedLines(LineReader& lines, std::string name) : lines_(lines), name_(std::move(name)) {}
  std::optional<std::string> Next(int milliseconds, bool) override {
    const bool first = !lines_.begun() && !lines_.at_terminal() && !name_.empty();
    std::optional<std::string> line = lines_.Next(milliseconds);
    if (first && line && CaseFolded(*line) == CaseFolded(name_)) return std::nullopt;
    return line;
  }
  bool ended() const override { return lines_.ended(); }

 private:
  LineReader& lines_;
  std::string name_;
};

}  // namespace

std::unique_ptr<LearnInput> InputFor(const std::optional<KeyMap>& keys, LineReader& lines,
                                     const std::string& name, Console& console) {
  if (keys) return std::make_unique<KeyInput>(*keys, console);
  return std::make_unique<TypedLines>(lines, name);
}

}  // namespace moontrace
