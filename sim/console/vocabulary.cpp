#include "sim/console/vocabulary.h"

#include <algorithm>
#include <iterator>

#include "sim/console/word_messages.h"
#include "textures/base/nearest_word.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

constexpr std::array<bool, kWordPlaces> In(std::string_view places) {
  return {places.find('L') != std::string_view::npos, places.find('O') != std::string_view::npos,
          places.find('T') != std::string_view::npos, places.find('D') != std::string_view::npos,
          places.find('B') != std::string_view::npos};
}

/// L: a lesson, O: a loop or view, T: the tutor's terminal, D: the demonstration, B: a book.
constexpr auto kWords = std::to_array<TypedWord>({
    {1, "stop", In("LOTDB"), false, "", "no force at once; go goes on"},
    {2, "next", In("LOTDB"), false, "", "on: the next page, the next step; leaves a sign"},
    {3, "where", In("LOTB"), false, "", "where the tip is, where the lesson is"},
    {4, "letter", In("L"), false, "", "the sign under the tip"},
    {5, "spell", In("LB"), false, "", "its word, sign by sign"},
    {6, "word", In("LB"), false, "", "its word"},
    {7, "bigger", In("LOB"), false, "", "larger letters"},
    {8, "smaller", In("LOB"), false, "", "smaller letters"},
    {9, "more help", In("L"), false, "", "a stronger push"},
    {10, "less help", In("L"), false, "", "a weaker push"},
    {11, "slower", In("L"), false, "", "a slower push"},
    {12, "faster", In("L"), false, "", "a faster push"},
    {13, "hint", In("L"), false, "", "the memory aid of a sign"},
    {14, "again", In("LTD"), false, "", "the same once more"},
    {15, "go", In("LOTDB"), false, "", "on again after a stop or a pause"},
    {16, "pause", In("LOTDB"), false, "", "a rest, without force"},
    {17, "done", In("L"), false, "", "what you traced is finished"},
    {18, "quit", In("LOTDB"), false, "", "ends; a tutor leaves, and the lesson goes on"},
    {19, "help", In("LOTDB"), false, "WORD",
     "the words, or what one does; a tutor's help 7: the push"},
    {20, "skip", In("LT"), true, "", "leaves a sign"},
    {21, "lessons", In("L"), true, "", "the lessons with their numbers, and where you are"},
    {22, "how am i doing", In("L"), true, "", "what is sure, and how sure"},
    {23, "brief", In("L"), true, "", "outcomes only"},
    {24, "full", In("L"), true, "", "all is said again"},
    {25, "my text", In("LB"), true, "TEXT",
     "a text of your own to read; in a book the sentence at the tip becomes it"},
    {26, "back", In("LOB"), true, "", "the page before, the text before"},
    {27, "mark", In("OB"), false, "", "the way to the bookmark that two presses set"},
    {28, "size", In("OTB"), false, "20 mm", "letters of that height"},
    {29, "depth", In("OTB"), false, "50 %", "grooves as deep, of the usual"},
    {30, "width", In("OTB"), false, "120 %", "grooves as wide, of the usual"},
    {31, "spacing", In("OTB"), false, "120 %", "from letter to letter and line to line"},
    {32, "pitch", In("OTB"), false, "150 %", "from line to line alone"},
    {33, "tilt", In("OTB"), false, "10 degrees", "the far edge of the page raised"},
    {34, "engraved", In("OTB"), false, "", "letters are grooves"},
    {35, "embossed", In("OTB"), false, "", "letters are ridges"},
    {36, "form", In("OTB"), false, "arc", "of H: crescent, arc, pocket or reverse-n"},
    {37, "paper", In("OTB"), false, "sine", "smooth, sine, grid or noise"},
    {38, "mode", In("T"), false, "bead", "how it pushes"},
    {39, "show", In("T"), false, "", "leads the hand along what lies there"},
    {40, "say", In("T"), false, "TEXT", "a line to the learner"},
    {41, "lesson", In("LT"), true, "5", "goes to that lesson, by number or name"},
    {42, "record", In("T"), false, "", "begins and ends taking the tutor's own stroke"},
    {43, "playback", In("T"), false, "", "leads the learner along that stroke"},
    {44, "who", In("T"), false, "", "who is here"},
    {45, "practise", In("L"), true, "b", "a sign that is known, once more"},
    {46, "more time", In("D"), false, "", "all waits are longer"},
    {47, "next lesson", In("T"), true, "", "on to the next lesson"},
    {48, "find", In("LOTB"), true, "TEXT",
     "turns to where that stands in the text, and says the way"},
    {49, "find next", In("LOTB"), true, "", "where it stands once more"},
    {50, "return", In("LOTB"), true, "", "back to where you were before you looked for something"},
    {51, "next line", In("LOTB"), true, "", "the way to the beginning of the next line"},
    {52, "next heading", In("LOTB"), true, "", "likewise, of the next heading"},
    {53, "next paragraph", In("OB"), true, "", "likewise, of the next paragraph"},
    {54, "next link", In("OB"), true, "", "likewise, of the next link"},
    {55, "go to", In("OB"), true, "40", "to a page; in a book also print 12, or a bookmark's name"},
    {56, "contents", In("B"), true, "3", "the table of contents, or the way to one of its lines"},
    {57, "follow", In("B"), true, "", "the link or the note at the tip; return comes back"},
    {58, "bookmark", In("B"), true, "NAME", "sets one here, as two presses do"},
    {59, "bookmarks", In("B"), true, "", "all of them"},
    {60, "forget", In("B"), true, "NAME", "takes that bookmark away"},
    {61, "labels", In("O"), true, "", "the labels of a model"},
    {62, "next label", In("O"), true, "", "to the next of them; find and a name goes to that"},
});

bool Begins(std::string_view whole, std::string_view begin) {
  return whole.substr(0, begin.size()) == begin;
}

/// The words of a place that begin so: the older ones, else those that came late.
std::vector<const TypedWord*> Begun(std::string_view given, WordPlace place) {
  std::vector<const TypedWord*> found;
  for (const bool late : {false, true}) {
    for (const TypedWord& word : kWords) {
      const bool fits = word.late == late && word.HoldsIn(place) && Begins(word.word, given);
      if (fits) found.push_back(&word);
    }
    if (!found.empty()) break;
  }
  return found;
}

/// The one that was meant, if the others are only longer.
const TypedWord* Meant(const std::vector<const TypedWord*>& begun) {
  for (const TypedWord* word : begun) {
    const auto longer = [word](const TypedWord* other) { return Begins(other->word, word->word); };
    if (std::all_of(begun.begin(), begun.end(), longer)) return word;
  }
  return nullptr;
}

/// The word that a beginning is short for in some place, the one of the smallest number.
const TypedWord* OwnerOf(std::string_view given) {
  const TypedWord* owner = nullptr;
  for (std::size_t place = 0; place < kWordPlaces; ++place) {
    const TypedWord* word = Meant(Begun(given, static_cast<WordPlace>(place)));
    if (word != nullptr && (owner == nullptr || word->number < owner->number)) owner = word;
  }
  return owner;
}

const TypedWord* WholeOrNumber(std::string_view given) {
  for (const TypedWord& word : kWords) {
    if (given == word.word || given == std::to_string(word.number)) return &word;
  }
  return given == "?" ? WordNamed("help") : nullptr;
}

std::string_view Trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const auto begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

bool Empty(const WordFound& found) {
  return found.word == nullptr && found.begun.empty() && found.elsewhere == nullptr;
}

/// The longest word that stands whole at a line's begin with something behind it.
const TypedWord* WholeBefore(std::string_view line, WordPlace place) {
  const TypedWord* longest = nullptr;
  for (const TypedWord& word : kWords) {
    const bool fits = word.HoldsIn(place) && Begins(line, word.word) &&
                      line.size() > word.word.size() && line[word.word.size()] == ' ';
    if (!fits) continue;
    const bool better = longest == nullptr || word.word.size() > longest->word.size();
    if (better) longest = &word;
  }
  return longest;
}

SaidLine Refused(std::string refusal) { return {nullptr, {}, std::move(refusal), {}}; }

/// "go!" is "go"; marks that stand alone are kept: "?", "find .".
std::string_view WithoutMarks(std::string_view given) {
  const auto last = given.find_last_not_of(".!?");
  const bool attached = last != std::string_view::npos && given[last] != ' ' && given[last] != '\t';
  return attached ? given.substr(0, last + 1) : given;
}

/// "please, stop" is "stop".
std::string_view WithoutPlease(std::string_view given) {
  constexpr std::string_view kPlease = "please";
  if (!Begins(given, kPlease)) return given;
  const std::string_view behind = given.substr(kPlease.size());
  const auto begin = behind.find_first_not_of(" \t,");
  return begin == 0 || begin == std::string_view::npos ? given : behind.substr(begin);
}

/// Whole or by its number, and whatever stands behind it: who wants all force gone may say more
/// than the word.
bool BeginsWithStop(std::string_view given) {
  given = WithoutPlease(given);
  const std::string_view first = given.substr(0, given.find_first_of(" \t.,;:!?"));
  return first == "stop" || first == "halt" || given.substr(0, given.find_first_of(" \t")) == "1";
}

/// What stands behind the word may end with a mark of its own.
bool TakesText(const TypedWord& word) {
  return word.behind == "TEXT" || word.behind == "NAME" || word.word == "practise" ||
         word.word == "go to";
}

/// The word that a line means as a whole, though it is put otherwise: "go on", "pause please",
/// "what"; null: none.
const TypedWord* PutOtherwise(std::string_view given, WordPlace place) {
  constexpr std::pair<std::string_view, const char*> kOthers[] = {
      {"go on", "go"},     {"carry on", "go"},          {"continue", "go"},  {"what", "again"},
      {"pardon", "again"}, {"say that again", "again"}, {"repeat", "again"}, {"exit", "quit"},
      {"bye", "quit"},     {"goodbye", "quit"},         {"wait", "pause"},   {"halt", "stop"},
      {"larger", "bigger"}};
  constexpr std::string_view kPlease = " please";
  const std::string_view whole = given;
  given = WithoutPlease(given);
  if (given.ends_with(kPlease)) {
    given = Trimmed(given.substr(0, given.size() - kPlease.size()));
    while (given.ends_with(',')) given.remove_suffix(1);
  }
  if (given != whole) {
    const TypedWord* word = WordNamed(given);
    if (word != nullptr && word->HoldsIn(place)) return word;
  }
  for (const auto& [other, word] : kOthers) {
    if (given == other && WordNamed(word)->HoldsIn(place)) return WordNamed(word);
  }
  if (place == WordPlace::kDemonstration) {  // words of a lesson, which do the like there
    if (given == "slower") return WordNamed("more time");
    if (given == "hint") return WordNamed("again");
  }
  return nullptr;
}

/// The word for what other programs, and people, call otherwise; empty: none.
std::string CalledElsewhere(std::string_view given) {
  constexpr std::pair<std::string_view, const char*> kOthers[] = {{"end", "quit"},
                                                                  {"previous", "back"}};
  for (const auto& [other, word] : kOthers) {
    if (given == other) return word;
  }
  return {};
}

SaidLine Said(const WordFound& found, std::string_view given, std::string_view behind,
              std::string_view line, WordPlace place) {
  if (found.word != nullptr) return {found.word, std::string(behind), {}};
  if (!found.begun.empty()) {
    return Refused(say::WordAmbiguous(given, {found.begun.begin(), found.begun.end()}));
  }
  if (found.here != nullptr) {
    return Refused(say::WordShortElsewhere(given, found.elsewhere->word, found.here->word));
  }
  // what nobody typed is not answered: of a number the number is told
  const bool number = given.find_first_not_of("0123456789") == std::string_view::npos;
  if (given == "size" && place == WordPlace::kLesson) {  // a learner's letters have steps
    return Refused(say::WordInstead(given, "bigger or smaller"));
  }
  if (found.elsewhere != nullptr) {
    return Refused(say::WordNotHere(number ? given : found.elsewhere->word));
  }
  const std::vector<std::string> words = WordsIn(place);
  std::string meant = CalledElsewhere(given);
  if (std::find(words.begin(), words.end(), meant) == words.end()) {
    meant = NearestWord(std::string(given), words);
  }
  SaidLine refused = Refused(say::WordUnknown(line, meant));
  const bool takes = !meant.empty() && !behind.empty() && !WordNamed(meant)->behind.empty();
  refused.meant = takes ? meant + " " + std::string(behind) : std::move(meant);
  return refused;
}

}  // namespace

const std::vector<TypedWord>& Vocabulary() {
  static const std::vector<TypedWord> words(kWords.begin(), kWords.end());
  return words;
}

const TypedWord* WordNamed(std::string_view word) {
  const auto found = std::find_if(kWords.begin(), kWords.end(),
                                  [word](const TypedWord& one) { return one.word == word; });
  return found == kWords.end() ? nullptr : found;
}

const TypedWord* WholeWord(std::string_view given, WordPlace place) {
  given = WithoutMarks(given);
  if (const TypedWord* word = PutOtherwise(given, place)) return word;
  const TypedWord* word = WordNamed(given);
  return word != nullptr && word->HoldsIn(place) ? word : nullptr;
}

std::vector<std::string> WordsIn(WordPlace place) {
  std::vector<std::string> words;
  for (const TypedWord& word : kWords) {
    if (word.HoldsIn(place)) words.emplace_back(word.word);
  }
  return words;
}

WordFound FindWord(std::string_view given, WordPlace place) {
  WordFound found;
  if (given.empty()) return found;
  const TypedWord* whole = WholeOrNumber(given);
  if (whole != nullptr && whole->HoldsIn(place)) return {whole};
  const std::vector<const TypedWord*> begun = Begun(given, place);
  const TypedWord* meant = Meant(begun);
  if (meant != nullptr) {
    const TypedWord* owner = OwnerOf(given);
    if (owner == meant) return {meant};
    found.elsewhere = owner;
    found.here = meant;
    return found;
  }
  if (begun.empty()) found.elsewhere = whole;
  std::transform(begun.begin(), begun.end(), std::back_inserter(found.begun),
                 [](const TypedWord* word) { return word->word; });
  return found;
}

SaidLine ReadLine(std::string_view line, WordPlace place) {
  std::string_view typed = Trimmed(line);
  if (!typed.empty() && typed.front() == '/') typed = Trimmed(typed.substr(1));
  if (typed.empty()) return {};
  const std::string given = LowerCase(typed);
  if (BeginsWithStop(given)) return {WordNamed("stop"), {}, {}};
  const std::string_view bare = WithoutMarks(given);
  if (const TypedWord* word = PutOtherwise(bare, place)) return {word, {}, {}};
  const WordFound alone = FindWord(bare, place);
  // "find n" looks for an n: only the whole of "find next" is that word
  const TypedWord* before = WholeBefore(given, place);
  const bool wants = before != nullptr && !before->behind.empty() &&
                     (alone.word == nullptr || alone.word->word != bare);
  if (!wants && !Empty(alone)) return Said(alone, bare, {}, typed, place);
  std::size_t end = std::min(bare.find_first_of(" \t"), bare.size());
  WordFound first = FindWord(bare.substr(0, end), place);
  if (const TypedWord* whole = WholeBefore(given, place)) {
    first = {whole};
    end = whole->word.size();
  }
  std::string_view behind = Trimmed(typed.substr(end));
  if (end == bare.size() || (first.word != nullptr && !TakesText(*first.word))) {
    behind = end == bare.size() ? std::string_view() : WithoutMarks(behind);
  }
  const bool alone_only = first.word != nullptr && first.word->behind.empty() && !behind.empty();
  if (alone_only) return Refused(say::WordStandsAlone(first.word->word, behind));
  return Said(first, bare.substr(0, end), behind, typed, place);
}

bool SaysYes(std::string_view line) {
  const std::string said = LowerCase(Trimmed(line));
  const std::string first = said.substr(0, said.find_first_of(" .,;:!"));
  for (const char* yes : {"yes", "y", "yess", "ok", "okay", "sure"}) {
    if (first == yes) return true;
  }
  return false;
}

void Proposal::MakeHelp(std::string_view given, WordPlace place) {
  const std::string meant = ReadLine(given, place).meant;
  Make(meant.empty() ? std::string() : "help " + meant);
}

std::string Proposal::Taken(const std::string& line) {
  std::string meant = std::exchange(line_, {});
  return !meant.empty() && SaysYes(line) ? meant : line;
}

}  // namespace moontrace
