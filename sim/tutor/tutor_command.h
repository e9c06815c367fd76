#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "lessons/course/guidance_mode.h"
#include "sim/tutor/page_words.h"

namespace moontrace {

/// What a tutor can say to a running lesson.
enum class TutorWord : std::uint8_t {
  kStop,        ///< as pause, and all sound and speech end
  kHelp,        ///< help
  kMode,        ///< mode
  kPage,        ///< page
  kPause,       ///< the push and the page's force rest
  kGo,          ///< on after a pause; never after the learner's own stop
  kShow,        ///< leads the learner's hand along what lies there
  kSay,         ///< text, for the learner to hear or read
  kAgain,       ///< the same once more
  kSkip,        ///< on to the next item
  kNext,        ///< as if the learner said it
  kPlace,       ///< likewise; text: "find moon", "next line"
  kNextLesson,  ///< on to the next lesson
  kLesson,      ///< text: the lesson's number, its id or a beginning of it, as given
  kRecord,      ///< takes the tutor's own stroke from the device; again: ends it
  kPlayback,    ///< leads the learner along the recorded stroke
  kWhere,       ///< lesson, step, item, size, help, what the tip feels
  kWho,         ///< learner and tutors
  kQuit,        ///< this tutor leaves; the lesson goes on
  kQuestion,    ///< what can be said; text: the word that is asked about; empty: all
};

/// One command, read.
struct TutorCommand {
  TutorWord word = TutorWord::kQuestion;
  int help = 0;  ///< 0-10
  GuidanceMode mode = GuidanceMode::kOff;
  std::string text = {};  ///< without control characters; not empty where the word wants one
  std::optional<PageCommand> page = {};  ///< of kPage: the change
};

/// A line that is no command: one line for the tutor: what is wrong, and the cure.
struct TutorRefusal {
  std::string line;
  std::string meant = {};  ///< SaidLine::meant
};

/// A word of a tutor as ReadLine has it (sim/console/vocabulary.h); behind it what the word wants:
/// a change of the page as ReadPageCommand takes it, a number, a mode, or a text. Capitals count in
/// texts only. Any bytes may be given. An empty line is a refusal too.
std::variant<TutorCommand, TutorRefusal> ReadTutorCommand(std::string_view line);

}  // namespace moontrace
