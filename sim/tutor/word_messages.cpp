#include "sim/tutor/word_messages.h"

#include <fmt/core.h>

#include "sim/console/wording.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

namespace {

/// So much of what was typed that the whole refusal stays on one line.
std::string Given(std::string_view given) { return OneLine(given, 12); }

}  // namespace

std::string NumberedWords(const std::vector<std::string>& words) {
  std::vector<std::string> numbered;
  numbered.reserve(words.size());
  for (const std::string& word : words) {
    numbered.push_back(fmt::format("{} {}", numbered.size() + 1, word));
  }
  return fmt::format("Words, or their beginning or number: {}.", Joined(numbered, ", "));
}

std::string WordUnknown(std::string_view given, std::string_view nearest) {
  return fmt::format("Unknown: {}. {}Type ? for the words.", OneLine(given, 20),
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

std::string WordStandsAlone(std::string_view word, std::string_view given) {
  return fmt::format("{} stands alone: leave out {}.", word, OneLine(given, 40));
}

}  // namespace moontrace::say
