#include "sim/learn/learn_words.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "lessons/progress/answer.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

using Kind = LearnLine::Kind;

std::string_view WithoutBlanks(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\r";
  const auto begin = line.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return line.substr(begin, line.find_last_not_of(kBlanks) - begin + 1);
}

std::string Trimmed(std::string_view line) { return LowerCase(WithoutBlanks(line)); }

/// Without the slash before and the question mark behind: "/word?" -> "word".
std::string Bare(std::string given) {
  if (!given.empty() && given.front() == '/') given = Trimmed(given.substr(1));
  if (given.size() > 1 && given.back() == '?') given = Trimmed(given.substr(0, given.size() - 1));
  return given;
}

LearnLine Word(LearnWord word) { return {Kind::kWord, word, {}}; }
LearnLine Answer(std::string answer) {
  return {Kind::kAnswer, LearnWord::kHelp, std::move(answer)};
}

std::optional<LearnWord> WholeWord(const std::string& given) {
  const std::vector<std::string>& words = LearnWords();
  const auto found = std::find(words.begin(), words.end(), given);
  if (found != words.end()) return static_cast<LearnWord>(found - words.begin());
  return given == "?" ? std::optional(LearnWord::kHelp) : std::nullopt;
}

LearnLine Command(const std::string& given) {
  if (const auto word = WholeWord(given)) return Word(*word);
  const std::vector<std::string>& words = LearnWords();
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (given == std::to_string(i + 1)) return Word(static_cast<LearnWord>(i));
  }
  const std::vector<std::string> found = LearnWordsFrom(given);
  if (found.size() == 1) return Word(*WholeWord(found.front()));
  return {found.empty() ? Kind::kUnknown : Kind::kAmbiguous, LearnWord::kHelp, {}};
}

/// What stands behind a word and a blank.
std::optional<std::string> Behind(std::string_view word, const std::string& given) {
  const bool begins = given.compare(0, word.size(), word) == 0;
  if (!begins || given.size() <= word.size() || given[word.size()] != ' ') return std::nullopt;
  return Trimmed(std::string_view(given).substr(word.size() + 1));
}

bool Begins(std::string_view word, const std::string& given) {
  return given.size() > 1 && word.compare(0, given.size(), given) == 0;
}

bool IsSign(const std::string& given) {
  const bool digits = given.find_first_not_of("0123456789") == std::string::npos;
  return digits || CountCharacters(given) == 1;
}

}  // namespace

const std::vector<std::string>& LearnWords() {
  static const std::vector<std::string> words = {
      "stop",    "next",           "where",   "letter",    "spell",
      "word",    "bigger",         "smaller", "more help", "less help",
      "slower",  "faster",         "hint",    "again",     "go",
      "pause",   "done",           "quit",    "help",      "skip",
      "lessons", "how am i doing", "brief",   "full",      "my text"};
  return words;
}

std::vector<std::string> LearnWordsFrom(std::string_view line) {
  const std::string given = Bare(Trimmed(line));
  constexpr std::ptrdiff_t kFirst = 19;
  const std::vector<std::string>& words = LearnWords();
  std::vector<std::string> found;
  const auto begins = [&given](const std::string& word) {
    return word.compare(0, given.size(), given) == 0;
  };
  std::copy_if(words.begin(), words.begin() + kFirst, std::back_inserter(found), begins);
  if (found.empty()) {
    std::copy_if(words.begin() + kFirst, words.end(), std::back_inserter(found), begins);
  }
  return found;
}

LearnLine ReadLearnLine(std::string_view line, Asked asked, const Course& course) {
  const std::string given = Trimmed(line);
  if (given.empty() && asked == Asked::kText) return {Kind::kMyText, LearnWord::kHelp, {}};
  if (given.empty()) return {};
  const std::string bare = Bare(given);
  if (bare.empty()) return Word(LearnWord::kHelp);  // a slash alone
  const bool is_item = asked == Asked::kName && ItemSaid(course, given, {});
  if (auto lesson = Behind("lesson", bare); lesson && !is_item) {
    return {Kind::kLesson, LearnWord::kHelp, *std::move(lesson)};
  }
  if (auto sign = Behind("practise", bare); sign && !is_item) {
    return {Kind::kPractise, LearnWord::kHelp, *std::move(sign)};
  }
  if (bare == "practise" && !is_item) return {Kind::kPractise, LearnWord::kHelp, {}};
  if (Behind("my text", bare) && !is_item) {
    // as it was typed: capitals are part of a text
    constexpr std::string_view kWord = "my text";
    const std::size_t begin = LowerCase(line).find(kWord) + kWord.size();
    return {Kind::kMyText, LearnWord::kHelp, std::string(WithoutBlanks(line.substr(begin)))};
  }
  if (asked == Asked::kNothing || given.front() == '/') return Command(bare);
  if (bare == "stop") return Word(LearnWord::kStop);
  if (bare == "quit") return Word(LearnWord::kQuit);
  if (asked == Asked::kText) {
    if (given == "?") return Word(LearnWord::kHelp);
    return {Kind::kMyText, LearnWord::kHelp, std::string(WithoutBlanks(line))};
  }
  if (asked == Asked::kSame) {
    if (SameSaid(given)) return Answer(given);
    for (const char* word : {"same", "different"}) {
      if (Begins(word, given)) return Answer(word);
    }
    return Command(bare);
  }
  if (given != "?" && ItemSaid(course, given, {})) return Answer(given);
  if (const auto word = WholeWord(bare)) return Word(*word);
  if (IsSign(given)) return Answer(given);
  const LearnLine command = Command(bare);
  return command.kind == Kind::kUnknown ? Answer(given) : command;
}

}  // namespace moontrace
