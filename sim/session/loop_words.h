#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "sim/console/vocabulary.h"
#include "sim/session/place_walk.h"
#include "sim/tutor/page_words.h"

namespace moontrace {

/// What people can say to a running loop.
enum class LoopWord : std::uint8_t {
  kStop,
  kNext,
  kWhere,
  kBigger,
  kSmaller,
  kGo,
  kPause,
  kQuit,
  kHelp,  ///< text: the word that is asked about; empty: all
  kBack,
  kMark,
  kLabels,
  kNextLabel,
  kPage,     ///< one of PageWords
  kPlace,    ///< one of PlaceWords
  kNothing,  ///< an empty line
  kRefused,  ///< no such word, the beginning of several, or what stands behind it is wrong
};

/// A line, read.
struct LoopLine {
  LoopWord word = LoopWord::kNothing;
  PageCommand page = {};     ///< of kPage
  PlaceCommand place = {};   ///< of kPlace
  std::string text = {};     ///< what stands behind the word
  std::string refusal = {};  ///< of kRefused: one line: what is wrong, and the cure
  std::string meant = {};    ///< of kRefused: SaidLine::meant
};

/// A word of a loop as ReadLine has it (sim/console/vocabulary.h); behind those that change the
/// page what they want (ReadPageCommand). `place`: of a loop, or of a book, whose own words are
/// read elsewhere and give kNothing.
LoopLine ReadLoopLine(std::string_view line, WordPlace place = WordPlace::kLoop);

}  // namespace moontrace
