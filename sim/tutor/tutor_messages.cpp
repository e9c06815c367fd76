#include "sim/tutor/tutor_messages.h"

#include <fmt/core.h>

#include "sim/console/wording.h"
#include "sim/tutor/page_messages.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

std::string TutorMayJoin() { return "A tutor may join from a second terminal: moontrace tutor."; }

std::string TutorSaidNothing() { return "Nothing was said. Say ? for the words."; }

std::string TutorCame(std::size_t tutor) {
  return fmt::format("Tutor {} is here, and sees what you are told.", tutor);
}

std::string TutorLeft(std::size_t tutor) { return fmt::format("Tutor {} has left.", tutor); }

std::string TutorDropped(std::size_t tutor) {
  return fmt::format("Tutor {} was let go: it did not read what it was sent.", tutor);
}

std::string TutorLineTooLong(std::size_t longest) {
  return fmt::format("Too long, not read: a line holds at most {} bytes.", longest);
}

std::string StrangerRefused() { return "Someone who is not you wanted in as tutor: refused."; }

std::string TooManyTutors(std::size_t most) {
  return fmt::format("No room: {} are here already. Try again later.",
                     Counted(most, "tutor", "tutors"));
}

std::string SocketTaken(std::string_view path) {
  return fmt::format(
      "the tutor socket is already taken: another lesson of this learner runs; end it, or use "
      "another --learner: {}",
      OneLine(path, 300));
}

std::string SocketIsNoSocket(std::string_view path) {
  return fmt::format("the tutor socket has no place: something else has its name; move it away: {}",
                     OneLine(path, 300));
}

std::string FolderNotOurs(std::string_view folder) {
  return fmt::format(
      "no tutor can come: the folder for its socket is another user's or no folder; set "
      "XDG_RUNTIME_DIR to one of your own: {}",
      OneLine(folder, 300));
}

std::string FolderOpenToOthers(std::string_view folder) {
  return fmt::format(
      "no tutor can come: others may enter the folder for its socket; close it with chmod 700: {}",
      OneLine(folder, 300));
}

std::string CannotOpenSocket(std::string_view path, std::string_view cause) {
  return fmt::format("no tutor can come: the socket cannot be opened, {}: {}", cause,
                     OneLine(path, 300));
}

std::string NoLessonRuns(std::string_view learner, std::string_view nearest) {
  return fmt::format("no lesson{} runs here with a tutor: {}",
                     learner.empty() ? std::string() : fmt::format(" of {}", OneLine(learner)),
                     nearest.empty() ? "start one with moontrace learn --tutor"
                                     : fmt::format("did you mean {}?", OneLine(nearest)));
}

std::string SeveralLessons(const std::vector<std::string>& learners) {
  return fmt::format("several lessons run: choose with --learner: {}", Joined(learners, ", "));
}

std::string LessonRefused(std::string_view path, std::string_view cause) {
  return fmt::format("the lesson cannot be reached, {}: {}", cause, OneLine(path, 300));
}

std::string LessonEnded() { return "It has ended: nobody is there any more."; }

std::string LessonSilent() { return "the lesson has not answered for 5 s"; }

std::string TutorGone() { return "You have left; the lesson goes on."; }

std::string TutorDoes(const TutorCommand& command) {
  if (command.page) return fmt::format("Tutor: {}.", PageBecomes(*command.page));
  switch (command.word) {
    case TutorWord::kStop:
      return "Tutor: stop.";
    case TutorWord::kPause:
      return "Tutor: pause, no force.";
    case TutorWord::kGo:
      return "Tutor: going on.";
    case TutorWord::kShow:
      return "Tutor shows: let your hand be led.";
    case TutorWord::kSay:
      return fmt::format("Tutor says: {}", OneLine(command.text, 900));
    case TutorWord::kAgain:
      return "Tutor: once more.";
    case TutorWord::kSkip:
      return "Tutor: skipped.";
    case TutorWord::kNext:
      return "Tutor: next.";
    case TutorWord::kPlace:
      return fmt::format("Tutor: {}.", OneLine(command.text, 60));
    case TutorWord::kNextLesson:
      return "Tutor: the next lesson.";
    case TutorWord::kLesson:
      return "Tutor: another lesson.";  // which one, the lesson says itself
    case TutorWord::kRecord:
      return "Tutor takes the device for a stroke.";
    case TutorWord::kPlayback:
      return "Tutor's stroke: let your hand be led.";
    default:
      break;  // between tutor and program
  }
  return {};
}

std::string WithoutTutor(std::string sentence) {
  constexpr std::string_view kTutor = "Tutor: ";
  if (!sentence.starts_with(kTutor)) return sentence;
  sentence.erase(0, kTutor.size());
  if (!sentence.empty() && sentence[0] >= 'a' && sentence[0] <= 'z') {
    sentence[0] = static_cast<char>(sentence[0] - 'a' + 'A');
  }
  return sentence;
}

std::string LearnerStopped() { return "The learner has stopped: only the learner goes on."; }
std::string LearnerAt(std::string_view learner, std::string_view status) {
  return fmt::format("{}: {}", OneLine(learner), status);
}
std::string WhoIsHere(std::string_view learner, std::size_t tutors) {
  return fmt::format("Learner: {}; {} here.", OneLine(learner), Counted(tutors, "tutor", "tutors"));
}

}  // namespace moontrace::say
