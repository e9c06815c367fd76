#include "sim/learn/learn_tutor.h"

#include <cmath>
#include <ctime>
#include <utility>
#include <variant>

#include "lessons/course/lesson_items.h"
#include "lessons/guide/guidance.h"
#include "lessons/guide/guidance_path.h"
#include "lessons/progress/lesson_path.h"
#include "sim/console/word_messages.h"
#include "sim/learn/learn_memory.h"
#include "sim/learn/learn_messages.h"
#include "sim/learn/learn_stage.h"
#include "sim/learn/learn_teller.h"
#include "sim/learn/learn_tutor_messages.h"
#include "sim/tutor/page_messages.h"
#include "sim/tutor/tutor_messages.h"
#include "textures/base/error.h"

namespace moontrace {

namespace {

/// Tutors who come in through the door have numbers from 1.
constexpr std::size_t kAtWindow = 0;

/// What would ask, lead or show something has to wait for a device that is lost.
bool NeedsDevice(const TutorCommand& command) {
  switch (command.word) {
    case TutorWord::kShow:
    case TutorWord::kPlayback:
    case TutorWord::kRecord:
    case TutorWord::kAgain:
    case TutorWord::kSkip:
    case TutorWord::kNext:
    case TutorWord::kNextLesson:
    case TutorWord::kLesson:
    case TutorWord::kPlace:
      return true;
    default:
      return false;
  }
}

/// The lesson machine says what became of it, before the page shows it.
bool LessonTells(const TutorCommand& command) {
  const bool size = command.page && command.page->word == PageWord::kSize;
  return size || command.word == TutorWord::kHelp || command.word == TutorWord::kMode;
}

}  // namespace

TutorDesk::TutorDesk(const LearnParts& parts, RunningLesson& lesson, bool door, Told window)
    : course_(parts.course),
      memory_(parts.memory),
      stage_(parts.stage),
      teller_(parts.teller),
      lesson_(lesson),
      window_(std::move(window)) {
  const std::string& name = memory_.name();
  if (door) server_.emplace(name, say::TutorGreeting(name));
  teller_.SetListener([this](std::string_view line) {
    if (server_) server_->SendToAll(line);
    if (window_) window_(line);
  });
}

TutorDesk::~TutorDesk() {
  teller_.SetListener(nullptr);
  stage_.SetTap(nullptr);
}

void TutorDesk::Serve() {
  if (server_) {
    for (const std::string& sentence : server_->TakeSentences()) {
      teller_.Say(Priority::kMessage, sentence);
    }
    while (const std::optional<TutorServer::Line> line = server_->Next()) Take(*line);
  }
  if (recorder_ && recorder_->full()) {
    teller_.Say(Priority::kMessage, say::TutorGaveBack());
    Record(kAtWindow);
  }
  teller_.EndTurn();
}

void TutorDesk::Hear(const std::string& line, const Told& answer) {
  answer_ = answer;
  Take({kAtWindow, line});
  answer_ = nullptr;
  teller_.EndTurn();
}

void TutorDesk::Take(TutorServer::Line line) {
  Proposal& proposal = proposals_[line.tutor];
  line.text = proposal.Taken(line.text);
  const auto read = ReadTutorCommand(line.text);
  if (const auto* refusal = std::get_if<TutorRefusal>(&read)) {
    proposal.Make(refusal->meant);
    Answer(line.tutor, refusal->line);
  } else {
    Do(line, std::get<TutorCommand>(read));
  }
}

void TutorDesk::Answer(std::size_t tutor, std::string_view line) {
  if (tutor != kAtWindow) {
    server_->Answer(tutor, line);
  } else if (answer_) {
    answer_(line);
  }
}

/// Who sits alone at the window's panel has no tutor.
std::string TutorDesk::Does(const TutorCommand& command) const {
  std::string sentence = say::TutorDoes(command);
  return server_ ? sentence : say::WithoutTutor(std::move(sentence));
}

/// All of them, or what one does.
void TutorDesk::TellWords(std::size_t tutor, const std::string& word) {
  if (!word.empty()) return Answer(tutor, say::HelpWith(word, WordPlace::kTutor));
  Answer(tutor, say::NumberedWords(WordPlace::kTutor));
  Answer(tutor, say::TutorWordsHelp());
  Answer(tutor, say::PageWordsHelp());
}

void TutorDesk::Do(const TutorServer::Line& line, const TutorCommand& command) {
  if (lesson_.waits() && NeedsDevice(command)) {
    return Answer(line.tutor, say::WaitsForDevice());
  }
  switch (command.word) {
    case TutorWord::kQuestion:
      return TellWords(line.tutor, command.text);
    case TutorWord::kWhere:
      Answer(line.tutor, say::LearnerAt(memory_.name(), lesson_.Status()));
      for (const std::string& more : lesson_.StatusForTutor()) Answer(line.tutor, more);
      return;
    case TutorWord::kWho:
      return Answer(line.tutor, say::WhoIsHere(memory_.name(), server_ ? server_->tutors() : 0));
    case TutorWord::kQuit:
      Answer(line.tutor, say::TutorGone());
      if (line.tutor != kAtWindow) server_->Dismiss(line.tutor);
      return;
    case TutorWord::kGo:
      if (!lesson_.stopped()) return Answer(line.tutor, say::NothingRests());
      if (!lesson_.GoOn(true)) return Answer(line.tutor, say::LearnerStopped());
      break;
    case TutorWord::kShow:
    case TutorWord::kPlayback:
      // the learner must not wait for a push that cannot come
      if (!stage_.pushes()) return Answer(line.tutor, say::CannotLead());
      if (command.word == TutorWord::kPlayback && !stroke_) {
        return Answer(line.tutor, say::NoStrokeYet());
      }
      break;
    case TutorWord::kRecord:
      // the program's hand is on the page, not the tutor's
      if (stage_.simulated()) return Answer(line.tutor, say::CannotRecord());
      break;
    case TutorWord::kLesson:
      if (!LessonNamed(course_, command.text)) {
        return Answer(line.tutor, say::LessonNotFound(course_, command.text, true));
      }
      break;
    case TutorWord::kNextLesson:
      if (!NextInOrder(course_, lesson_.state().progress)) {
        return Answer(line.tutor, say::NoNextLesson());
      }
      break;
    default:
      break;
  }
  if (command.page && command.page->word != PageWord::kSize) return ChangeForm(line, command);
  const bool gives_back = command.word == TutorWord::kRecord && recorder_;
  if (!LessonTells(command)) {
    teller_.Say(Priority::kMessage, gives_back ? say::TutorGaveBack() : Does(command));
    teller_.Flush();
  }
  memory_.Note(static_cast<std::int64_t>(std::time(nullptr)), "tutor", line.text);
  try {
    if (!DoToPage(line.tutor, command)) DoToLesson(command);
  } catch (const InputError& error) {
    teller_.Say(Priority::kMessage, say::PageStays(error.what()));
  }
}

/// Told once it is so: not every page can take every form.
void TutorDesk::ChangeForm(const TutorServer::Line& line, const TutorCommand& command) {
  try {
    if (command.page->word == PageWord::kTilt) {
      stage_.SetTilt(command.page->value);
    } else {
      stage_.SetForm(Changed(stage_.form(), *command.page));
    }
  } catch (const InputError& error) {
    return Answer(line.tutor, say::PageStays(error.what()));
  }
  teller_.Say(Priority::kMessage, Does(command));
  teller_.Flush();
  memory_.Note(static_cast<std::int64_t>(std::time(nullptr)), "tutor", line.text);
}

/// Whatever changes the hand's path on the page.
bool TutorDesk::DoToPage(std::size_t tutor, const TutorCommand& command) {
  switch (command.word) {
    case TutorWord::kStop:
      lesson_.Stop(true);
      return true;
    case TutorWord::kPause:
      lesson_.Pause(true);
      return true;
    case TutorWord::kShow:
      lesson_.Lead(MakeGuidancePath(stage_.trace().strokes()));
      return true;
    case TutorWord::kRecord:
      Record(tutor);
      return true;
    case TutorWord::kPlayback:
      PlayBack();
      return true;
    default:
      return false;
  }
}

/// What overrules the rules of the course.
void TutorDesk::DoToLesson(const TutorCommand& command) {
  lesson_event::Overrule overrule;
  switch (command.word) {
    case TutorWord::kPage:  // size: the rest was done by ChangeForm
      overrule.size = command.page->value;
      break;
    case TutorWord::kHelp:
      overrule.help = command.help;
      break;
    case TutorWord::kMode:
      overrule.mode = command.mode;
      break;
    case TutorWord::kSkip:
      overrule.skip = true;
      break;
    case TutorWord::kNext:
      return lesson_.Obey("/next");
    case TutorWord::kPlace:
      return lesson_.Obey("/" + command.text);
    case TutorWord::kNextLesson:
      overrule.next_lesson = true;
      break;
    case TutorWord::kLesson:
      overrule.lesson = course_.lessons[*LessonNamed(course_, command.text)].id;
      break;
    case TutorWord::kAgain:
      return lesson_.TutorSays({lesson_event::Word::kAgain, true});
    default:
      return;  // told, and no more: "say"
  }
  lesson_.Overrule(overrule);
}

void TutorDesk::Record(std::size_t tutor) {
  if (!recorder_) {
    recorder_.emplace();
    stage_.SetTap([this](const LoopSample& sample) {
      recorder_->Add(sample.time, sample.tip_P, sample.in_contact);
    });
    return Answer(tutor, say::Recording());
  }
  stage_.SetTap(nullptr);
  std::optional<RecordedStroke> stroke = recorder_->Stroke();
  recorder_.reset();
  stage_.Restart();  // what the tutor's hand did is not the learner's
  if (!stroke) return Answer(tutor, say::NothingRecorded());
  stroke_ = std::move(stroke);
  Answer(tutor, say::RecordedStrokeIs(stroke_->times.back()));
}

void TutorDesk::PlayBack() {
  const double width = stage_.session().text().set.style.width;
  lesson_.Lead(MakeRecordedPath(stroke_->times, stroke_->tips_P, width));
}

}  // namespace moontrace
