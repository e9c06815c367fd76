#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/tutor/page_words.h"

namespace moontrace {

/// What people can say to a running loop.
enum class LoopWord : std::uint8_t {
  kStop,
  kGo,
  kBigger,
  kSmaller,
  kNext,
  kBack,
  kWhere,
  kMark,
  kQuit,
  kPage,  ///< one of PageWords
  kPause,
  kHelp,
  kNothing,  ///< an empty line
  kRefused,  ///< no such word, the beginning of several, or what stands behind it is wrong
};

/// A line, read.
struct LoopLine {
  LoopWord word = LoopWord::kNothing;
  PageCommand page = {};     ///< of kPage
  std::string refusal = {};  ///< of kRefused: one line: what is wrong, and the cure
};

/// The words by their numbers, from 1: stop, go, ...
const std::vector<std::string>& LoopWords();

/// A word, an unambiguous beginning of one, its number, or "?" for help; behind those that change
/// the page what they want (ReadPageCommand). Capitals and blanks around do not count.
LoopLine ReadLoopLine(std::string_view line);

}  // namespace moontrace
