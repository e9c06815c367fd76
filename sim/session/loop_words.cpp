#include "sim/session/loop_words.h"

#include <utility>
#include <variant>

#include "sim/tutor/word_line.h"
#include "sim/tutor/word_messages.h"
#include "textures/base/nearest_word.h"

namespace moontrace {

namespace {

/// How many words come before those of the page.
constexpr std::size_t kBefore = static_cast<std::size_t>(LoopWord::kPage);

LoopLine Refused(std::string refusal) { return {LoopWord::kRefused, {}, std::move(refusal)}; }

LoopLine ReadPageLine(PageWord word, const std::string& behind) {
  auto read = ReadPageCommand(word, behind);
  if (auto* refusal = std::get_if<std::string>(&read)) return Refused(std::move(*refusal));
  return {LoopWord::kPage, std::get<PageCommand>(std::move(read)), {}};
}

}  // namespace

const std::vector<std::string>& LoopWords() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> all = {"stop", "go",    "bigger", "smaller", "next",
                                    "back", "where", "mark",   "quit"};
    all.insert(all.end(), PageWords().begin(), PageWords().end());
    all.emplace_back("pause");
    return all;
  }();
  return words;
}

LoopLine ReadLoopLine(std::string_view line) {
  const WordLine said = SplitWord(line);
  if (said.word.empty()) return {};
  const bool asks = said.behind.empty() && (said.word == "?" || said.word == "help");
  if (asks) return {LoopWord::kHelp};
  const WordChoice choice = ChooseWord(said.word, LoopWords());
  if (!choice.index) {
    if (!choice.begun.empty()) return Refused(say::WordAmbiguous(said.word, choice.begun));
    return Refused(say::WordUnknown(said.word, NearestWord(said.word, LoopWords())));
  }
  const std::size_t index = *choice.index;
  const bool is_page = index >= kBefore && index < kBefore + PageWords().size();
  if (is_page) return ReadPageLine(static_cast<PageWord>(index - kBefore), said.behind);
  if (!said.behind.empty()) {
    return Refused(say::WordStandsAlone(LoopWords()[index], said.behind));
  }
  if (index > kBefore) return {LoopWord::kPause};
  return {static_cast<LoopWord>(index)};
}

}  // namespace moontrace
