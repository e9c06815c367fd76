#include "sim/learn/key_wording.h"

#include <array>
#include <optional>
#include <utility>

namespace moontrace {

namespace {

using Keys = std::map<std::string, std::string>;

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// A word that has a key, and the key's name.
struct Keyed {
  std::string_view word;
  std::string key;
};

/// The longest word of them that stands whole at `at`.
std::optional<Keyed> WordAt(std::string_view sentence, std::size_t at, const Keys& keys) {
  std::optional<Keyed> found;
  for (const auto& [key, word] : keys) {
    const std::size_t end = at + word.size();
    const bool whole = sentence.compare(at, word.size(), word) == 0 &&
                       (end == sentence.size() || !IsLetter(sentence[end]));
    const bool better = whole && (!found || word.size() > found->word.size());
    if (better && key != "F1") found = {word, KeyCalled(key)};
  }
  return found;
}

/// What stands before a word that is to be said, and before its key.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kBefore = {{
    {"say ", "press "},
    {"Say ", "Press "},
    {"type ", "press "},
    {"Type ", "Press "},
    {"The word ", "The key "},
    {"; ", "; "},     // "; next leaves it": before one of kVerbs only
    {", ", ", "},     // likewise
    {"words: ", ""},  // a list, see ListAt
}};
constexpr std::size_t kSaid = 4;    ///< of kBefore: those behind which Enter is typed
constexpr std::size_t kNamed = 5;   ///< those with a verb behind the word begin here
constexpr std::size_t kListed = 7;  ///< the list

/// The Enter that goes with a typed word.
constexpr std::array<std::string_view, 5> kEnters = {
    ", and press Enter", " and press Enter", ", then Enter", " and Enter", ", typed with Enter"};

/// Behind a word that stands for itself.
constexpr std::array<std::string_view, 4> kVerbs = {" leaves", " tells", " ends", " goes on"};

template <std::size_t kCount>
std::size_t LengthOf(const std::array<std::string_view, kCount>& parts, std::string_view text) {
  for (const std::string_view part : parts) {
    if (text.compare(0, part.size(), part) == 0) return part.size();
  }
  return 0;
}

/// "again, where, more help." with each one's key: "again r, where w, more help right bracket".
/// Empty: what stands there is no list of words.
std::string ListAt(std::string_view sentence, std::size_t& at, const Keys& keys) {
  std::string list;
  std::size_t end = at;
  while (const std::optional<Keyed> one = WordAt(sentence, end, keys)) {
    list += std::string(list.empty() ? "" : ", ") + std::string(one->word) + " " + one->key;
    end += one->word.size();
    if (sentence.compare(end, 2, ", ") != 0) break;
    end += 2;
  }
  if (!list.empty()) at = end;
  return list;
}

/// What stands at `at`, with keys; moves `at` behind it. Empty: nothing of that kind.
std::string PartAt(std::string_view sentence, std::size_t& at, const Keys& keys) {
  for (std::size_t i = 0; i < kBefore.size(); ++i) {
    const auto& [before, instead] = kBefore[i];
    if (sentence.compare(at, before.size(), before) != 0) continue;
    std::size_t end = at + before.size();
    if (i == kListed) {
      std::string list = ListAt(sentence, end, keys);
      if (list.empty()) continue;
      at = end;
      return "words: " + list;
    }
    const std::optional<Keyed> word = WordAt(sentence, end, keys);
    if (!word) continue;
    end += word->word.size();
    if (i >= kNamed && LengthOf(kVerbs, sentence.substr(end)) == 0) continue;
    if (i < kSaid) end += LengthOf(kEnters, sentence.substr(end));
    at = end;
    return std::string(instead) + word->key;
  }
  return {};
}

}  // namespace

std::string KeyCalled(const std::string& key) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kCalled = {{
      {"+", "plus"},
      {"-", "minus"},
      {"[", "left bracket"},
      {"]", "right bracket"},
      {",", "comma"},
      {".", "full stop"},
      {"?", "question mark"},
  }};
  for (const auto& [sign, name] : kCalled) {
    if (key == sign) return std::string(name);
  }
  return key;
}

std::string WithKeys(std::string_view sentence, const Keys& keys) {
  std::string told;
  for (std::size_t at = 0; at < sentence.size();) {
    const bool within = at > 0 && IsLetter(sentence[at - 1]) && IsLetter(sentence[at]);
    std::string part = !within ? PartAt(sentence, at, keys) : std::string();
    told += part.empty() ? std::string(1, sentence[at++]) : part;
  }
  constexpr std::string_view kWords = "Say ? for the words.";
  const auto words = told.find(kWords);
  if (words != std::string::npos) told.replace(words, kWords.size(), "? tells the keys.");
  return told;
}

}  // namespace moontrace
