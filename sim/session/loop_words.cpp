#include "sim/session/loop_words.h"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "sim/console/vocabulary.h"

namespace moontrace {

namespace {

struct Entry {
  LoopWord word;
  std::string_view name;
};

/// Those that change the page are PageWords.
constexpr std::array kWords = {
    Entry{LoopWord::kStop, "stop"},           Entry{LoopWord::kNext, "next"},
    Entry{LoopWord::kWhere, "where"},         Entry{LoopWord::kBigger, "bigger"},
    Entry{LoopWord::kSmaller, "smaller"},     Entry{LoopWord::kGo, "go"},
    Entry{LoopWord::kPause, "pause"},         Entry{LoopWord::kQuit, "quit"},
    Entry{LoopWord::kHelp, "help"},           Entry{LoopWord::kBack, "back"},
    Entry{LoopWord::kMark, "mark"},           Entry{LoopWord::kLabels, "labels"},
    Entry{LoopWord::kNextLabel, "next label"}};

LoopLine Refused(std::string refusal, std::string meant = {}) {
  LoopLine line{LoopWord::kRefused};
  line.refusal = std::move(refusal);
  line.meant = std::move(meant);
  return line;
}

}  // namespace

LoopLine ReadLoopLine(std::string_view line, WordPlace place) {
  SaidLine said = ReadLine(line, place);
  if (!said.refusal.empty()) return Refused(std::move(said.refusal), std::move(said.meant));
  if (said.word == nullptr) return {};
  const std::string_view name = said.word->word;
  if (const std::optional<PageWord> page = PageWordOf(name)) {
    auto read = ReadPageCommand(*page, said.behind);
    if (auto* refusal = std::get_if<std::string>(&read)) return Refused(std::move(*refusal));
    LoopLine change{LoopWord::kPage};
    change.page = std::get<PageCommand>(std::move(read));
    return change;
  }
  if (std::optional<PlaceCommand> leads = PlaceCommandOf(name, said.behind)) {
    LoopLine way{LoopWord::kPlace};
    way.place = std::move(*leads);
    return way;
  }
  const auto found = std::find_if(kWords.begin(), kWords.end(),
                                  [name](const Entry& entry) { return entry.name == name; });
  if (found == kWords.end()) return {};
  LoopLine word{found->word};
  word.text = std::move(said.behind);
  return word;
}

}  // namespace moontrace
