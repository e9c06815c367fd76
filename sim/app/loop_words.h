#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

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
  kHelp,
  kNothing,    ///< an empty line
  kUnknown,    ///< no such word
  kAmbiguous,  ///< the beginning of several
};

/// The words by their numbers, from 1: stop, go, ...
const std::vector<std::string>& LoopWords();

/// A word, an unambiguous beginning of one, its number, or "?" for help; capitals and blanks around
/// do not count.
LoopWord ReadLoopWord(std::string_view line);

/// The words that begin with `line`.
std::vector<std::string> LoopWordsFrom(std::string_view line);

}  // namespace moontrace
