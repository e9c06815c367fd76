#include "sim/learn/learn_words.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "lessons/progress/answer.h"
#include "sim/console/vocabulary.h"
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

/// Without the slash before and the question mark behind: "/word?" -> "word".
std::string_view Bare(std::string_view given) {
  if (!given.empty() && given.front() == '/') given = WithoutBlanks(given.substr(1));
  if (given.size() > 1 && given.back() == '?') {
    given = WithoutBlanks(given.substr(0, given.size() - 1));
  }
  return given;
}

LearnLine Word(LearnWord word) { return {Kind::kWord, word, {}, {}}; }
LearnLine Answer(std::string answer) {
  return {Kind::kAnswer, LearnWord::kHelp, std::move(answer), {}};
}

/// Words that are kinds of their own, since something stands behind them.
std::optional<Kind> KindOf(std::string_view word) {
  if (word == "lesson") return Kind::kLesson;
  if (word == "practise") return Kind::kPractise;
  if (word == "my text") return Kind::kMyText;
  return std::nullopt;
}

/// A word with what stands behind it, as it was typed.
LearnLine Said(std::string_view word, std::string_view behind) {
  if (std::optional<PlaceCommand> place = PlaceCommandOf(word, behind)) {
    return {Kind::kPlace, LearnWord::kHelp, {}, std::move(*place)};
  }
  const std::optional<Kind> kind = KindOf(word);
  const bool asks = word == "my text" && behind.empty();
  if (kind && !asks) {
    const bool text = *kind == Kind::kMyText;  // capitals are part of a text
    return {*kind, LearnWord::kHelp, text ? std::string(behind) : LowerCase(behind), {}};
  }
  const std::vector<std::string>& words = LearnWords();
  const auto found = std::find(words.begin(), words.end(), word);
  return {Kind::kWord, static_cast<LearnWord>(found - words.begin()), std::string(behind), {}};
}

LearnLine Command(std::string_view typed) {
  SaidLine said = ReadLine(typed, WordPlace::kLesson);
  if (said.word == nullptr) {
    return {Kind::kRefused, LearnWord::kHelp, std::move(said.refusal), {}, std::move(said.meant)};
  }
  return Said(said.word->word, said.behind);
}

/// Neither a word, here or elsewhere, nor the beginning or the number of one, nor behind a whole
/// one.
bool IsNoWord(const LearnLine& read, const std::string& given) {
  if (read.kind != Kind::kRefused || given.front() == '/') return false;
  if (given.find_first_not_of("0123456789") == std::string::npos) return false;
  const TypedWord* first = WordNamed(std::string_view(given).substr(0, given.find(' ')));
  if (first != nullptr && first->HoldsIn(WordPlace::kLesson)) return false;
  const WordFound found = FindWord(given, WordPlace::kLesson);
  return found.begun.empty() && found.elsewhere == nullptr;
}

/// A whole word that wants something behind it, with that: no answer, whatever is asked. Of a text
/// of one's own, "help" begins one unless a word stands behind it.
std::optional<LearnLine> WithBehind(std::string_view typed, Asked asked) {
  const std::string given = LowerCase(typed);
  for (const char* name : {"lesson", "practise", "my text", "help", "find"}) {
    const std::string_view word = name;
    const bool begins = given.compare(0, word.size(), word) == 0;
    const bool alone = begins && given.size() == word.size();
    if (alone && KindOf(word)) return Said(word, {});
    if (!begins || given.size() <= word.size() || given[word.size()] != ' ') continue;
    const std::string_view behind = WithoutBlanks(typed.substr(word.size()));
    if (PlaceCommandOf(word, {})) return Command(typed);  // "find next" is another word
    const bool is_help = KindOf(word) || asked != Asked::kText ||
                         ReadLine(behind, WordPlace::kLesson).word != nullptr;
    if (is_help) return Said(word, behind);
  }
  return std::nullopt;
}

bool Begins(std::string_view word, const std::string& given) {
  return given.size() > 1 && word.compare(0, given.size(), given) == 0;
}

bool IsNumber(const std::string& given) {
  return given.find_first_not_of("0123456789") == std::string::npos;
}

bool IsSign(const std::string& given) { return IsNumber(given) || CountCharacters(given) == 1; }

/// A word, or the beginning of one or several: of two letters or more.
bool IsWord(const std::string& bare) {
  const WordFound found = FindWord(bare, WordPlace::kLesson);
  return found.word != nullptr || !found.begun.empty();
}

/// "stop", and more behind it. A text of one's own may begin so, too: there what is behind must be
/// of who wants it now.
bool SaysStop(const std::string& bare, Asked asked) {
  const bool stop = bare.compare(0, 4, "stop") == 0 &&
                    ReadLine(bare, WordPlace::kLesson).word == WordNamed("stop");
  if (!stop || asked != Asked::kText) return stop;
  constexpr std::string_view kMore[] = {"now", "please", "stop", "it", "this", "at", "once"};
  std::string_view rest = std::string_view(bare).substr(4);
  while (!rest.empty()) {
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t.,;:!?"), rest.size()));
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t.,;:!?"));
    if (!word.empty() && std::find(std::begin(kMore), std::end(kMore), word) == std::end(kMore)) {
      return false;
    }
    rest.remove_prefix(word.size());
  }
  return true;
}

LearnLine WhereNameIsAsked(std::string_view typed, const std::string& given,
                           const std::string& bare, const Course& course) {
  if (given != "?" && ItemSaid(course, given, {})) return Answer(given);
  const TypedWord* whole = given == "?" ? WordNamed("help") : WholeWord(bare, WordPlace::kLesson);
  if (whole != nullptr) return Said(whole->word, {});
  if (IsSign(given) || !IsWord(bare)) return Answer(given);
  return Command(typed);
}

}  // namespace

const std::vector<std::string>& LearnWords() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> all = WordsIn(WordPlace::kLesson);
    const auto others = [](const std::string& word) {
      if (PlaceCommandOf(word, {})) return true;
      return KindOf(word) && word != "my text";  // which alone asks for a text
    };
    all.erase(std::remove_if(all.begin(), all.end(), others), all.end());
    return all;
  }();
  return words;
}

LearnLine ReadLearnLine(std::string_view line, Asked asked, const Course& course) {
  const std::string given = LowerCase(WithoutBlanks(line));
  if (given.empty() && asked == Asked::kText) return {Kind::kMyText, LearnWord::kHelp, {}, {}};
  if (given.empty()) return {};
  if (given == "? all" || given == "help all" || given == "/help all") {
    return {Kind::kWord, LearnWord::kHelp, "all", {}};
  }
  const std::string_view typed = Bare(WithoutBlanks(line));
  if (typed.empty()) return Word(LearnWord::kHelp);  // a slash alone
  const std::string bare = LowerCase(typed);
  const bool names = asked == Asked::kName || asked == Asked::kNumber;
  const bool is_item = names && ItemSaid(course, given, {});
  const std::optional<LearnLine> with = WithBehind(typed, asked);
  if (with && !is_item) return *with;
  if (asked == Asked::kNothing || given.front() == '/') {
    LearnLine read = Command(typed);
    const bool would_answer = DoesNotKnow(given) || ItemSaid(course, given, {});
    return would_answer && IsNoWord(read, given) ? Answer(given) : read;
  }
  if (bare == "stop" || (!is_item && SaysStop(bare, asked))) return Word(LearnWord::kStop);
  if (bare == "quit") return Word(LearnWord::kQuit);
  if (asked != Asked::kText && DoesNotKnow(given)) return Answer(given);
  switch (asked) {
    case Asked::kText:
      if (given == "?") return Word(LearnWord::kHelp);
      return {Kind::kMyText, LearnWord::kHelp, std::string(WithoutBlanks(line)), {}};
    case Asked::kSame:
      if (SameSaid(given)) return Answer(given);
      for (const char* word : {"same", "different"}) {
        if (Begins(word, given)) return Answer(word);
      }
      if (LearnLine read = Command(typed); !IsNoWord(read, given)) return read;
      return Answer(given);
    case Asked::kName:
      if (IsNumber(bare)) return Command(typed);
      break;
    case Asked::kNumber:
    case Asked::kNothing:
      break;
  }
  return WhereNameIsAsked(typed, given, bare, course);
}

}  // namespace moontrace
