#include "lessons/progress/answer.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "lessons/course/lesson_items.h"

namespace moontrace {

namespace {

/// A longer text is no answer [bytes].
constexpr std::size_t kLongest = 1000;

/// Words that may stand before a name.
constexpr std::array<std::string_view, 14> kFillers = {
    "the",  "a",  "an", "letter", "letters", "capital", "small",
    "sign", "it", "is", "it's",   "word",    "number",  "digit"};

/// What may stand before all that, of who is not sure.
constexpr std::array<std::string_view, 6> kBegins = {"i think that ", "i think ", "i guess ",
                                                     "maybe ",        "perhaps ", "probably "};

/// English names of letters as they are written down, without those that are words themselves.
constexpr std::pair<std::string_view, std::string_view> kSpoken[] = {
    {"ay", "a"},  {"bee", "b"},      {"cee", "c"},      {"dee", "d"},    {"ee", "e"},  {"ef", "f"},
    {"eff", "f"}, {"gee", "g"},      {"aitch", "h"},    {"haitch", "h"}, {"eye", "i"}, {"jay", "j"},
    {"kay", "k"}, {"el", "l"},       {"ell", "l"},      {"em", "m"},     {"en", "n"},  {"oh", "o"},
    {"pee", "p"}, {"cue", "q"},      {"queue", "q"},    {"ar", "r"},     {"ess", "s"}, {"tee", "t"},
    {"vee", "v"}, {"double u", "w"}, {"double-u", "w"}, {"ex", "x"},     {"wye", "y"}, {"zed", "z"},
    {"zee", "z"}};

bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Small letters, one blank between words, none around.
std::string Plain(std::string_view text) {
  std::string plain;
  for (const char c : text) {
    if (IsBlank(c)) {
      if (!plain.empty() && plain.back() != ' ') plain += ' ';
    } else {
      plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
  }
  if (!plain.empty() && plain.back() == ' ') plain.pop_back();
  return plain;
}

bool IsCalled(const Course& course, std::string_view item, const std::string& reading) {
  return !reading.empty() && (reading == Plain(item) || reading == Plain(NameOf(course, item)));
}

}  // namespace

std::vector<std::string> ReadingsOf(std::string_view said) {
  std::vector<std::string> readings;
  if (said.size() > kLongest) return readings;
  readings.push_back(Plain(said));
  std::string rest = readings.front();
  if (rest.size() > 1 && (rest.back() == '.' || rest.back() == '!' || rest.back() == '?')) {
    rest.pop_back();
    readings.push_back(rest);
  }
  for (const std::string_view begin : kBegins) {
    if (rest.compare(0, begin.size(), begin) != 0) continue;
    rest.erase(0, begin.size());
    readings.push_back(rest);
    break;
  }
  for (auto blank = rest.find(' '); blank != std::string::npos; blank = rest.find(' ')) {
    const std::string_view word = std::string_view(rest).substr(0, blank);
    if (std::find(kFillers.begin(), kFillers.end(), word) == kFillers.end()) break;
    rest = rest.substr(blank + 1);
    readings.push_back(rest);
  }
  for (const auto& [spoken, letter] : kSpoken) {
    if (rest == spoken) readings.emplace_back(letter);
  }
  return readings;
}

bool DoesNotKnow(std::string_view said) {
  std::string plain = Plain(said);
  while (!plain.empty() && (plain.back() == '.' || plain.back() == '!')) plain.pop_back();
  for (const std::string_view mark : {"\u2019", "'"}) {  // typed without it, or as print has it
    const auto at = plain.find(mark);
    if (at != std::string::npos) plain.erase(at, mark.size());
  }
  for (const std::string_view begin : {"sorry, i ", "sorry i ", "sorry, ", "sorry ", "i "}) {
    if (plain.compare(0, begin.size(), begin) == 0) {
      plain.erase(0, begin.size());
      break;
    }
  }
  for (const std::string_view words :
       {"dont know", "do not know", "dunno", "have no idea", "no idea", "cant tell", "cannot tell",
        "am not sure", "not sure", "give up"}) {
    if (plain == words || plain == std::string(words) + " it") return true;
  }
  return false;
}

bool KnowsWithoutName(std::string_view said) {
  std::string plain = Plain(said);
  while (!plain.empty() && (plain.back() == '.' || plain.back() == '!')) plain.pop_back();
  for (const std::string_view begin : {"yes, ", "yes ", "oh, ", "oh ", "ah, ", "ah "}) {
    if (plain.compare(0, begin.size(), begin) == 0) plain.erase(0, begin.size());
  }
  for (const std::string_view words :
       {"i know", "i do know", "i know it", "i know that", "i know this", "i know that one",
        "i know this one", "i know what it is"}) {
    if (plain == words) return true;
  }
  return false;
}

bool Names(const Course& course, std::string_view item, std::string_view said) {
  return ItemSaid(course, said, item) == item;
}

std::optional<std::string> ItemSaid(const Course& course, std::string_view said,
                                    std::string_view expected) {
  const std::set<std::string> items = AllItems(course);
  for (const std::string& reading : ReadingsOf(said)) {
    if (IsCalled(course, expected, reading)) return std::string(expected);
    for (const std::string& item : items) {
      if (IsCalled(course, item, reading)) return item;
    }
  }
  return std::nullopt;
}

std::optional<bool> SameSaid(std::string_view said) {
  const std::vector<std::string> readings = ReadingsOf(said);
  for (const std::string& reading : readings) {
    for (const std::string_view word : {"same", "s", "yes", "y", "equal"}) {
      if (reading == word) return true;
    }
    for (const std::string_view word : {"different", "d", "no", "n", "not same", "not the same"}) {
      if (reading == word) return false;
    }
  }
  return std::nullopt;
}

}  // namespace moontrace
