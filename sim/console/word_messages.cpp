#include "sim/console/word_messages.h"

#include <fmt/core.h>

#include "sim/console/wording.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

namespace {

/// So much of what was typed that the whole refusal stays on one line.
std::string Given(std::string_view given) { return OneLine(given, 12); }

}  // namespace

std::string NumberedWords(WordPlace place) {
  std::vector<std::string> numbered;
  for (const TypedWord& word : Vocabulary()) {
    if (word.HoldsIn(place)) numbered.push_back(fmt::format("{} {}", word.number, word.word));
  }
  return fmt::format("Words, or their beginning or number: {}.", Joined(numbered, ", "));
}

std::string HelpWith(std::string_view given, WordPlace place) {
  const SaidLine said = ReadLine(given, place);
  if (said.word == nullptr) return said.refusal;
  const TypedWord& word = *said.word;
  const std::string behind = word.behind.empty() ? "" : fmt::format(" {}", word.behind);
  return fmt::format("{}{}, {}: {}.", word.word, behind, word.number, word.help);
}

std::string WordNotHere(std::string_view word) {
  return fmt::format("{} is no word here. Say ? for the words.", word);
}

std::string WordInstead(std::string_view word, std::string_view instead) {
  return fmt::format("{} is no word here: say {}.", word, instead);
}

std::string WordShortElsewhere(std::string_view given, std::string_view elsewhere,
                               std::string_view here) {
  return fmt::format("{} is short for {} elsewhere: say {}.", Given(given), elsewhere, here);
}

std::string WordUnknown(std::string_view given, std::string_view nearest) {
  return fmt::format("Unknown: {}. {}Say ? for the words.", Unstopped(OneLine(given, 40)),
                     nearest.empty() ? std::string() : fmt::format("Did you mean {}? ", nearest));
}

std::string WordAmbiguous(std::string_view given, const std::vector<std::string>& words) {
  return fmt::format("{} could be {}.", Given(given), Joined(words, " or "));
}

std::string WordWants(std::string_view word, std::string_view wants) {
  return fmt::format("{} lacks what it wants: {}.", word, wants);
}

std::string WordCannotBe(std::string_view word, std::string_view given, std::string_view wants) {
  return fmt::format("No {} {}: it wants {}.", word, Given(given), wants);
}

std::string WordOutOfRange(std::string_view word, std::string_view given, std::string_view wants) {
  return fmt::format("No {} {}, out of range: it wants {}.", word, Given(given), wants);
}

std::string Unstopped(std::string text) {
  const auto last = text.find_last_not_of(".!? ");
  if (last != std::string::npos) text.erase(last + 1);
  return text;
}

std::string NoTerminal() { return "single keys need a terminal: standard input is none"; }

std::string WordStandsAlone(std::string_view word, std::string_view given) {
  return fmt::format("Say {} alone, without {}.", word, Unstopped(OneLine(given, 36)));
}

}  // namespace moontrace::say
