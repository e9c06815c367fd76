#include "sim/demonstration/demonstration_messages.h"

#include <fmt/core.h>

#include "sim/console/word_messages.h"
#include "sim/console/wording.h"
#include "sim/learn/key_wording.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

std::vector<std::string> DemonstrationHelp() {
  std::vector<std::string> words;
  for (const TypedWord& word : Vocabulary()) {
    const bool holds = word.HoldsIn(WordPlace::kDemonstration);
    if (holds) words.push_back(fmt::format("{} {}", word.word, word.number));
  }
  return {fmt::format("Say a word, or its number: {}.", Joined(words, ", ")),
          "While I ask, a letter is an answer; I don't know tells it."};
}
std::vector<std::string> DemonstrationKeysHelp(const std::map<std::string, std::string>& keys) {
  std::vector<std::string> words;
  words.reserve(keys.size());
  for (const auto& [key, word] : keys) words.push_back(fmt::format("{} {}", KeyCalled(key), word));
  return {fmt::format("One key a word, without Enter: {}.", Joined(words, ", ")),
          "While I ask, a letter and Enter is an answer; I don't know tells it."};
}
std::string WrongAnswer(std::string_view given) {
  return fmt::format("Wrong: you said {}.", OneLine(given, 12));
}
std::string AnswerCameLate() { return "That came too late for the question before."; }
std::string WholeWordAsked() { return "The whole word is asked."; }
std::string NothingAsked(bool paused) {
  return paused ? "Nothing is asked now: say go." : "Nothing is asked now.";
}
std::string DemonstrationLeft() {
  return "The demonstration ends here. moontrace learn --device simulated begins it again.";
}
std::string DemonstrationCutOff() { return "End of input: the demonstration ends."; }
std::string DemonstrationPauses() { return "A pause. Say go when you like."; }
std::string DemonstrationGoesOn() { return "Going on."; }
std::string DemonstrationSlower() { return "More time from now on."; }

}  // namespace moontrace::say
