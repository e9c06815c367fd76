#include "sim/app/loop_words.h"

#include "textures/text_file.h"

namespace moontrace {

namespace {

std::string Trimmed(std::string_view line) {
  const auto begin = line.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return LowerCase(line.substr(begin, line.find_last_not_of(" \t") - begin + 1));
}

}  // namespace

const std::vector<std::string>& LoopWords() {
  static const std::vector<std::string> words = {"stop", "go",    "bigger", "smaller", "next",
                                                 "back", "where", "mark",   "quit"};
  return words;
}

std::vector<std::string> LoopWordsFrom(std::string_view line) {
  const std::string given = Trimmed(line);
  std::vector<std::string> found;
  for (const std::string& word : LoopWords()) {
    if (word.compare(0, given.size(), given) == 0) found.push_back(word);
  }
  return found;
}

LoopWord ReadLoopWord(std::string_view line) {
  const std::string given = Trimmed(line);
  if (given.empty()) return LoopWord::kNothing;
  if (given == "?" || given == "help") return LoopWord::kHelp;
  const std::vector<std::string>& words = LoopWords();
  std::size_t found = words.size();
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (given == words[i] || given == std::to_string(i + 1)) return static_cast<LoopWord>(i);
    if (words[i].compare(0, given.size(), given) != 0) continue;
    if (found < words.size()) return LoopWord::kAmbiguous;
    found = i;
  }
  return found < words.size() ? static_cast<LoopWord>(found) : LoopWord::kUnknown;
}

}  // namespace moontrace
