#include "sim/view/view_words.h"

#include <algorithm>
#include <array>

#include "textures/base/text_file.h"

namespace moontrace {

namespace {

struct Entry {
  ViewWord word;
  const char* text;
};

constexpr std::array kWords = {Entry{ViewWord::kZoomIn, "zoom in"},
                               Entry{ViewWord::kZoomOut, "zoom out"},
                               Entry{ViewWord::kWholePage, "whole page"},
                               Entry{ViewWord::kFollow, "follow"},
                               Entry{ViewWord::kFollowOff, "follow off"},
                               Entry{ViewWord::kPrintOn, "print on"},
                               Entry{ViewWord::kPrintOff, "print off"},
                               Entry{ViewWord::kPlotsOn, "plots on"},
                               Entry{ViewWord::kPlotsOff, "plots off"},
                               Entry{ViewWord::kPanelOn, "panel on"},
                               Entry{ViewWord::kPanelOff, "panel off"},
                               Entry{ViewWord::kContrastOn, "contrast on"},
                               Entry{ViewWord::kContrastOff, "contrast off"},
                               Entry{ViewWord::kLargeTextOn, "large text on"},
                               Entry{ViewWord::kLargeTextOff, "large text off"}};

/// Without the spaces around it.
std::string_view Trimmed(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return line.substr(begin, line.find_last_not_of(" \t") - begin + 1);
}

}  // namespace

std::optional<ViewWord> ViewWordOf(std::string_view line) {
  const std::string text = LowerCase(std::string(Trimmed(line)));
  for (const Entry& entry : kWords) {
    if (text == entry.text) return entry.word;
  }
  return std::nullopt;
}

std::optional<std::string> ViewedNameOf(std::string_view line) {
  constexpr std::string_view kWord = "view";
  const std::string_view text = Trimmed(line);
  if (LowerCase(std::string(text.substr(0, kWord.size()))) != kWord) return std::nullopt;
  const std::string_view rest = text.substr(kWord.size());
  if (!rest.empty() && rest[0] != ' ' && rest[0] != '\t') return std::nullopt;
  return std::string(Trimmed(rest));  // names have capitals
}

const std::vector<std::string>& ViewWords() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> all;
    all.reserve(kWords.size());
    for (const Entry& entry : kWords) all.emplace_back(entry.text);
    return all;
  }();
  return words;
}

}  // namespace moontrace
