#include "sim/book/book_tutor.h"

#include <utility>
#include <variant>

#include "sim/book/book_messages.h"
#include "sim/console/vocabulary.h"
#include "sim/console/word_messages.h"
#include "sim/tutor/page_messages.h"
#include "sim/tutor/tutor_messages.h"

namespace moontrace {

BookDesk::BookDesk(const std::string& learner, std::string_view title, BookWalk& walk)
    : walk_(walk), learner_(learner), server_(learner, say::BookGreeting(title, learner)) {}

void BookDesk::Answer(const TutorServer::Line& to, std::string_view line) {
  server_.Answer(to.tutor, line);
}

void BookDesk::Typed(std::string_view line) {
  const SaidLine said = ReadLine(line, WordPlace::kBook);
  if (said.word != nullptr && (said.word->word == "stop" || said.word->word == "pause")) {
    stopped_ = false;
  }
}

void BookDesk::Follow(const LoopSnapshot& now) {
  std::string line = walk_.LineHere(now);
  if (line.empty() || line == followed_) return;
  followed_ = std::move(line);
  server_.SendToAll(followed_);
}

std::optional<Elsewhere::Line> BookDesk::Next(const LoopSnapshot& now) {
  // a stop takes effect a moment after it was said
  if (rested_ && !now.stopped) stopped_ = false;
  rested_ = now.stopped;
  Follow(now);
  for (std::string& one : server_.TakeSentences()) {
    comings_.insert(comings_.begin(), std::move(one));
  }
  if (!comings_.empty()) {
    Line line{std::move(comings_.back()), {}};
    comings_.pop_back();
    return line;
  }
  while (const std::optional<TutorServer::Line> line = server_.Next()) {
    if (std::optional<Line> done = Take(*line, now)) return done;
  }
  return std::nullopt;
}

std::optional<Elsewhere::Line> BookDesk::Take(TutorServer::Line line, const LoopSnapshot& now) {
  Proposal& proposal = proposals_[line.tutor];
  line.text = proposal.Taken(line.text);
  const auto read = ReadTutorCommand(line.text);
  if (const auto* command = std::get_if<TutorCommand>(&read)) return Do(line, *command, now);
  if (ReadLine(line.text, WordPlace::kBook).word != nullptr) return TakeReadersWord(line, now);
  proposal.Make(std::get<TutorRefusal>(read).meant);
  Answer(line, std::get<TutorRefusal>(read).line);
  return std::nullopt;
}

void BookDesk::TellWords(const TutorServer::Line& to, const std::string& word) {
  if (!word.empty()) return Answer(to, say::HelpWith(word, WordPlace::kBook));
  Answer(to, say::NumberedWords(WordPlace::kBook));
  Answer(to, say::TutorWordsInBook());
  Answer(to, say::PageWordsHelp());
}

std::optional<Elsewhere::Line> BookDesk::Do(const TutorServer::Line& line,
                                            const TutorCommand& command, const LoopSnapshot& now) {
  switch (command.word) {
    case TutorWord::kQuestion:
      TellWords(line, command.text);
      return std::nullopt;
    case TutorWord::kWhere:
      for (const std::string& one : walk_.WhereIs(now)) Answer(line, say::LearnerAt(learner_, one));
      return std::nullopt;
    case TutorWord::kWho:
      Answer(line, say::WhoIsHere(learner_, server_.tutors()));
      return std::nullopt;
    case TutorWord::kQuit:
      Answer(line, say::TutorGoneFromBook());
      server_.Dismiss(line.tutor);
      return std::nullopt;
    case TutorWord::kGo:
      if (!now.stopped || !stopped_) {
        Answer(line, now.stopped ? say::LearnerStopped() : say::NothingRestsHere());
        return std::nullopt;
      }
      return Line{say::TutorDoes(command), "go"};
    case TutorWord::kStop:
    case TutorWord::kPause:
      stopped_ = !now.stopped || stopped_;
      return Line{say::TutorDoes(command), "stop"};
    case TutorWord::kSay:
      return Line{say::TutorDoes(command), {}};
    case TutorWord::kPage:
    case TutorWord::kNext:
    case TutorWord::kPlace:
      return Line{say::TutorDoes(command), line.text};
    case TutorWord::kHelp:
    case TutorWord::kMode:
    case TutorWord::kShow:
    case TutorWord::kAgain:
    case TutorWord::kSkip:
    case TutorWord::kNextLesson:
    case TutorWord::kLesson:
    case TutorWord::kRecord:
    case TutorWord::kPlayback:
      Answer(line, say::NotInBook(line.text));
      return std::nullopt;
  }
  return std::nullopt;
}

/// Words that a tutor has in a book alone.
std::optional<Elsewhere::Line> BookDesk::TakeReadersWord(const TutorServer::Line& line,
                                                         const LoopSnapshot& now) {
  const SaidLine said = ReadLine(line.text, WordPlace::kBook);
  if (said.word->word != "my text") {
    TutorCommand command{TutorWord::kPlace};
    command.text = line.text;
    return Line{say::TutorDoes(command), line.text};
  }
  if (said.behind.empty()) {
    Answer(line, say::PassageWanted());
  } else if (walk_.LayPassage(said.behind, now)) {
    return Line{say::PassageComes(), {}, true};
  } else {
    Answer(line, say::PassageCannotBe());
  }
  return std::nullopt;
}

}  // namespace moontrace
