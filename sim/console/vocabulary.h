#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace moontrace {

/// Where words are typed. A window with a panel has those of what runs in it.
enum class WordPlace : std::uint8_t { kLesson, kLoop, kTutor, kDemonstration, kBook };
inline constexpr std::size_t kWordPlaces = 5;

/// A word that can be said while something runs.
struct TypedWord {
  int number = 0;                         ///< the same wherever the word holds; 1 is "stop"
  std::string_view word;                  ///< in small letters; may hold blanks
  std::array<bool, kWordPlaces> holds{};  ///< by WordPlace
  bool late = false;                      ///< came later: see FindWord
  std::string_view behind;                ///< what stands behind it, for people; often empty
  std::string_view help;                  ///< one clause, without capital and stop

  bool HoldsIn(WordPlace place) const { return holds[static_cast<std::size_t>(place)]; }
};

/// All words, by ascending numbers.
const std::vector<TypedWord>& Vocabulary();
/// Null: no such word.
const TypedWord* WordNamed(std::string_view word);
/// The words that hold in a place, by ascending numbers.
std::vector<std::string> WordsIn(WordPlace place);

/// Which word of a place was meant.
struct WordFound {
  const TypedWord* word = nullptr;           ///< null: see the others
  std::vector<std::string_view> begun = {};  ///< several words begin so
  /// A whole word or number that holds in other places only, or a beginning that is short for
  /// another word there; `here`: the word that begins so in this place.
  const TypedWord* elsewhere = nullptr;
  const TypedWord* here = nullptr;
};

/// A whole word, its number, or an unambiguous beginning; "?" is help. `given` in small letters,
/// without blanks at its ends.
///
/// Beginnings mean the same in all places, or ask. Words that came late take nobody's short forms
/// away: they are looked at where no older word begins so. Of "next" and "next line" the shorter is
/// meant. A beginning that is short for two words in two places belongs to the smaller number.
WordFound FindWord(std::string_view given, WordPlace place);

/// The word that a line means as a whole, though it may be put otherwise: "go.", "go on", "pause
/// please", "what?". In small letters; null: none that holds there.
const TypedWord* WholeWord(std::string_view given, WordPlace place);

/// A typed line.
struct SaidLine {
  const TypedWord* word = nullptr;  ///< null: nothing was said, or see `refusal`
  std::string behind = {};          ///< as typed, without blanks at its ends
  std::string refusal = {};         ///< one line: what is wrong, and the cure
  std::string meant = {};           ///< of `refusal`: the line that it asks for, "Did you mean ..."
};

/// Reads a line: a word as FindWord has it, and what stands behind it, where the word wants
/// something. A "/" before, blanks and capitals do not count, nor a closing mark, unless it is of a
/// text behind a word.
SaidLine ReadLine(std::string_view line, WordPlace place);

/// "yes", and more behind it.
bool SaysYes(std::string_view line);

/// "Did you mean quit?" can be answered by yes, in the very next line.
class Proposal {
 public:
  /// What was answered to a line proposes this one; empty: nothing.
  void Make(std::string line) { line_ = std::move(line); }
  /// Likewise, where `given` stood behind "help".
  void MakeHelp(std::string_view given, WordPlace place);
  /// A line as it is meant: what was proposed, if it says yes. Nothing is proposed from now on.
  std::string Taken(const std::string& line);

 private:
  std::string line_;
};

}  // namespace moontrace
