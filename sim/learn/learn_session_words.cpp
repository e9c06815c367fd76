// The learner's words: what each does to the session, and its answer.

#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "lessons/course/lesson_items.h"
#include "lessons/progress/answer.h"
#include "lessons/progress/lesson_path.h"
#include "lessons/progress/mastery.h"
#include "sim/console/vocabulary.h"
#include "sim/console/word_messages.h"
#include "sim/learn/learn_messages.h"
#include "sim/learn/learn_session.h"
#include "sim/learn/learn_tutor_messages.h"
#include "sim/session/loop_messages.h"

namespace moontrace {

namespace {

using lesson_action::Await;

std::vector<std::string> CharactersOf(std::string_view utf8) {
  std::vector<std::string> characters;
  for (const char c : utf8) {
    if ((static_cast<unsigned char>(c) & 0xc0) != 0x80 || characters.empty()) {
      characters.emplace_back();
    }
    characters.back() += c;
  }
  return characters;
}

/// What the lesson machine answers to a word; none: the session does.
std::optional<lesson_event::Word> SaidToMachine(LearnWord word) {
  using Word = lesson_event::Word;
  switch (word) {
    case LearnWord::kAgain:
      return Word::kAgain;
    case LearnWord::kBigger:
      return Word::kBigger;
    case LearnWord::kSmaller:
      return Word::kSmaller;
    case LearnWord::kMoreHelp:
      return Word::kMoreHelp;
    case LearnWord::kLessHelp:
      return Word::kLessHelp;
    case LearnWord::kSlower:
      return Word::kSlower;
    case LearnWord::kFaster:
      return Word::kFaster;
    case LearnWord::kHint:
      return Word::kHint;
    case LearnWord::kSkip:
      return Word::kNext;
    default:
      return std::nullopt;
  }
}

}  // namespace

void LearnSession::Obey(const std::string& typed) {
  const std::string line = proposal_.Taken(typed);
  const int before = teller_.told();
  teller_.Interrupt();
  // while all rests, "go" is no answer, whatever the course teaches
  const bool was_stopped = stopped_;
  const bool goes =
      stopped_ && line.size() > 1 && ReadLine(line, WordPlace::kLesson).word == WordNamed("go");
  LearnLine read = ReadLearnLine(line, goes ? Asked::kNothing : asked(), course_);
  if (std::exchange(asks_sign_, false) && read.kind == LearnLine::Kind::kAnswer) {
    read.kind = LearnLine::Kind::kPractise;
    read.answer = ItemSaid(course_, line, {}).value_or(read.answer);
  }
  asks_text_ = false;
  if (read.kind != LearnLine::Kind::kWord || read.word != LearnWord::kHelp) helped_ = false;
  if (WaitsWith(read)) {
    teller_.Say(Priority::kText, say::WaitsForDevice());
    return teller_.EndTurn();
  }
  switch (read.kind) {
    case LearnLine::Kind::kWord:
      if (read.answer == "all") helped_ = true;
      if (!read.answer.empty() && read.answer != "all") {
        proposal_.MakeHelp(read.answer, WordPlace::kLesson);
        teller_.Say(Priority::kText, say::HelpWith(read.answer, WordPlace::kLesson));
        break;
      }
      Speak(read.word);
      break;
    case LearnLine::Kind::kAnswer:
      Answer(read.answer);
      break;
    case LearnLine::Kind::kLesson:
      GoToLesson(read.answer);
      break;
    case LearnLine::Kind::kPractise: {
      if (read.answer.empty()) {
        asks_sign_ = true;
        teller_.Say(Priority::kText, say::PractiseWhich());
        break;
      }
      lesson_event::Overrule overrule;
      overrule.practise = read.answer;
      Take(overrule);
      break;
    }
    case LearnLine::Kind::kMyText:
      OwnText(read.answer);
      break;
    case LearnLine::Kind::kPlace:
      GoToPlace(read.place);
      break;
    case LearnLine::Kind::kNothing:
      break;  // what is waited for
    case LearnLine::Kind::kRefused:
      proposal_.Make(read.meant);
      teller_.Say(Priority::kText, read.answer);
      break;
  }
  const bool stops = read.kind == LearnLine::Kind::kWord &&
                     (read.word == LearnWord::kStop || read.word == LearnWord::kPause);
  // What is shown and asked while all rests comes with no force: that must not be forgotten.
  const bool rests = was_stopped && stopped_ && !stops;
  const bool goes_there = read.kind == LearnLine::Kind::kPlace;  // told once the page lies there
  if (((teller_.told() == before && !goes_there) || rests) && !over_) {
    teller_.Say(Priority::kText, Awaited());
  }
  in_full_ = false;
  teller_.EndTurn();
}

/// What would ask, lead, show or count something has to wait for a device that is lost.
bool LearnSession::WaitsWith(const LearnLine& read) const {
  if (!away_) return false;
  if (read.kind == LearnLine::Kind::kRefused || read.kind == LearnLine::Kind::kNothing)
    return false;
  if (read.kind != LearnLine::Kind::kWord) return true;
  if (!read.answer.empty()) return false;  // help with a word
  if (SaidToMachine(read.word)) return true;
  switch (read.word) {
    case LearnWord::kNext:
    case LearnWord::kBack:
    case LearnWord::kDone:
    case LearnWord::kMyText:
      return true;
    case LearnWord::kGo:
      return !stopped_;
    default:
      return false;
  }
}

std::string LearnSession::Awaited() const {
  const bool felt = stage_.pushes();
  if (away_ && !stopped_) return say::WaitsForDevice();
  if (stopped_) return paused_ ? say::Pausing(felt) : say::Event(SafetyEvent::kStopped, felt);
  if (led_by_tutor_) return say::LedNow();
  if (await_ == Await::kTrace && stage_.simulated()) return say::ProgramTraces();
  if (await_ == Await::kTrace && leading_ && stage_.pushes()) return say::LedNow();
  const auto& [first, second] = std::minmax(state_.item, state_.mate);
  const std::string between =
      fmt::format("{} or {}", say::Called(course_, first), say::Called(course_, second));
  return say::Awaited(await_, state_.question, between, stage_.lifts());
}

void LearnSession::GoToLesson(const std::string& given) {
  if (given.empty()) return teller_.Say(Priority::kText, say::LessonWhich());
  const auto index = LessonNamed(course_, given);
  if (!index) {
    return teller_.Say(Priority::kText, say::LessonNotFound(course_, given, false));
  }
  lesson_event::Overrule overrule;
  overrule.lesson = course_.lessons[*index].id;
  Take(overrule);
}

void LearnSession::TellLessons() {
  const Progress& progress = state_.progress;
  for (std::size_t i = 0; i < course_.lessons.size(); ++i) {
    const Lesson& lesson = course_.lessons[i];
    const bool done =
        std::find(progress.done.begin(), progress.done.end(), lesson.id) != progress.done.end();
    teller_.Say(Priority::kText,
                say::LessonInList(lesson.title, i + 1, lesson.id == progress.lesson, done,
                                  lesson.optional));
  }
}

/// It was left in this session while it was shown: begun, and no more.
bool LearnSession::OnlyNamed(const std::string& text) const {
  const auto found = state_.progress.items.find(text);
  const bool known = found != state_.progress.items.end() && found->second.introduced;
  return !known && std::find(state_.named.begin(), state_.named.end(), text) != state_.named.end();
}

/// How far it is in all, then each sign that the present step still asks for.
void LearnSession::TellHowItGoes() {
  const Progress& progress = state_.progress;
  std::size_t begun = 0, all = 0;
  double smallest = 0;
  for (const Lesson& lesson : course_.lessons) all += lesson.items.size();
  begun = static_cast<std::size_t>(std::count_if(
      state_.named.begin(), state_.named.end(),
      [this](const std::string& text) { return IsTaught(course_, text) && OnlyNamed(text); }));
  for (const auto& [text, item] : progress.items) {
    if (!IsTaught(course_, text) || !item.introduced) continue;
    ++begun;
    if (!item.sure && item.size_step == 0) continue;
    const double size = SizeAt(course_, item.sure ? item.size_step : item.size_step - 1);
    smallest = smallest > 0 ? std::min(smallest, size) : size;
  }
  teller_.Say(Priority::kText, say::HowFar(begun, all, smallest));
  const std::vector<std::string> asked = Unfinished(course_, progress);
  TellOthers(asked);
  for (const std::string& text : asked) {
    const auto found = progress.items.find(text);
    const ItemProgress item = found != progress.items.end() ? found->second : ItemProgress{};
    const auto right = std::count(item.named.begin(), item.named.end(), true);
    teller_.Say(Priority::kText,
                say::HowSure(NameOf(course_, text), static_cast<std::size_t>(right),
                             item.named.size(), SizeAt(course_, item.size_step)));
  }
}

/// The signs that the present step does not ask for, by the smallest size at which they are sure.
void LearnSession::TellOthers(const std::vector<std::string>& asked) {
  std::map<double, std::vector<std::string>, std::greater<>> by_size;
  for (const Lesson& lesson : course_.lessons) {
    for (const std::string& text : lesson.items) {
      const auto found = state_.progress.items.find(text);
      const bool known = found != state_.progress.items.end() && found->second.introduced;
      if (!known && !OnlyNamed(text)) continue;
      if (std::find(asked.begin(), asked.end(), text) != asked.end()) continue;
      const ItemProgress item = known ? found->second : ItemProgress();
      const bool none = !item.sure && item.size_step == 0;
      const double size =
          none ? 0 : SizeAt(course_, item.sure ? item.size_step : item.size_step - 1);
      by_size[size].emplace_back(NameOf(course_, text));
    }
  }
  for (const auto& [size, names] : by_size) teller_.Say(Priority::kText, say::SureAt(names, size));
}

void LearnSession::Brief(bool brief) {
  memory_.SetBrief(Now(), brief);
  teller_.Say(Priority::kText, brief ? say::BriefNow() : say::FullNow());
}

/// Kept once it could be set: what cannot be shown is not what Enter takes the next time.
void LearnSession::OwnText(const std::string& given) {
  const std::string text = given.empty() ? memory_.own_text() : given;
  if (text.empty()) return teller_.Say(Priority::kText, say::NoOwnText());
  Take(lesson_event::OwnText{text});
  if (stage_.shown().text == text) memory_.SetOwnText(Now(), text);
}

/// What stands where is not told while it is asked.
void LearnSession::GoToPlace(const PlaceCommand& command) {
  if (!told()) return teller_.Say(Priority::kText, say::NotWhileAsked());
  teller_.Say(Priority::kText, walk_.Go(command, poll_.newest()));
}

void LearnSession::LookAtPlace() {
  const auto arrival = walk_.Arrived(poll_.newest());
  if (!arrival) return;
  teller_.Say(Priority::kText, arrival->sentence);
  if (stage_.pushes() && !stopped_) {
    Lead(PathTo(*arrival, stage_.session().text().set.style.width));
  }
}

/// What would be an answer where nothing is asked is answered by what is to be done.
void LearnSession::Answer(const std::string& text) {
  if (await_ != Await::kAnswer) {
    teller_.Say(Priority::kText, say::NothingIsAsked());
    return teller_.Say(Priority::kText, Awaited());
  }
  if (KnowsWithoutName(text)) {
    const bool same = state_.question == Question::kSame;
    return teller_.Say(Priority::kText, same ? Awaited() : say::SayTheName());
  }
  lesson_event::Answered answered;
  answered.text = text;
  answered.latency = felt_;
  answered.measured = Flags(stage_.trace().Measured());
  Take(std::move(answered));
}

void LearnSession::Speak(LearnWord word) {
  if (const auto said = SaidToMachine(word)) {
    in_full_ = word == LearnWord::kAgain || word == LearnWord::kHint;
    return Take(lesson_event::Said{*said, false});
  }
  switch (word) {
    case LearnWord::kNext:
      return Next();
    case LearnWord::kBack:
      return Back();
    case LearnWord::kLessons:
      return TellLessons();
    case LearnWord::kHow:
      return TellHowItGoes();
    case LearnWord::kBrief:
      return Brief(true);
    case LearnWord::kFull:
      return Brief(false);
    case LearnWord::kMyText:
      asks_text_ = true;
      return teller_.Say(Priority::kText, say::AskOwnText(memory_.own_text()));
    case LearnWord::kDone:
      return EndTrace();
    case LearnWord::kWhere:
      return Where();
    case LearnWord::kLetter:
    case LearnWord::kSpell:
    case LearnWord::kWord:
      return Letter(word);
    case LearnWord::kStop:
      return Stop(false);
    case LearnWord::kPause:
      return Rest();
    case LearnWord::kGo:
      if (!GoOn(false)) return teller_.Say(Priority::kText, say::NotStopped());
      return teller_.Say(Priority::kText, say::Event({LoopEventKind::kWentOn}, stage_.pushes()));
    case LearnWord::kQuit:
      over_ = true;
      return;
    case LearnWord::kHelp:
      return Help();
    default:
      return;  // the machine's
  }
}

/// At first what is needed now; who asks once more is told the rest.
void LearnSession::Help() {
  const bool more = std::exchange(helped_, !helped_);
  for (const std::string& line : more ? help_.more : help_.first) {
    teller_.Say(Priority::kText, line);
  }
}

void LearnSession::Rest() {
  if (stopped_) return teller_.Say(Priority::kText, say::AlreadyStopped());
  Pause(false);
  teller_.Say(Priority::kText, say::Pausing(stage_.pushes()));
}

/// A trace that was begun is judged, but one that fails a second time is left: who says next goes
/// on. A demonstration's hand is always on the page and makes nothing sure: there the sign is left.
bool LearnSession::JudgedAtNext() const {
  const LearnTrace& trace = stage_.trace();
  if (await_ != Await::kTrace || stage_.simulated() || !trace.followed()) return false;
  return missed_ != state_.item || GoodTrace(course_.mastery, trace.Measured());
}

/// A long text's next page comes before the next step.
void LearnSession::Next() {
  if (JudgedAtNext()) {
    EndTrace();
    const bool again = await_ == Await::kTrace && missed_ == state_.item && !leading_;
    if (again) teller_.Say(Priority::kText, say::NextLeavesIt());
    return;
  }
  if (await_ == Await::kNext && stage_.Turn(true)) {
    const LoopSession& session = stage_.session();
    return teller_.Say(Priority::kText,
                       say::NowPage(session.felt().index, session.text().set.pages.size()));
  }
  Take(lesson_event::Said{lesson_event::Word::kNext, false});
}

void LearnSession::Back() {
  if (!stage_.Turn(false)) return Take(lesson_event::Said{lesson_event::Word::kBack, false});
  const LoopSession& session = stage_.session();
  teller_.Say(Priority::kText, say::NowPage(session.felt().index, session.text().set.pages.size()));
}

void LearnSession::EndTrace() {
  if (await_ == Await::kAnswer) return teller_.Say(Priority::kText, say::StillAsked());
  if (await_ != Await::kTrace) return Next();
  const LearnTrace& trace = stage_.trace();
  const bool told = leading_ && !stage_.pushes();  // the path has been heard in words
  if (!trace.touched() && !told) {
    const bool mouse = stage_.session().device().mouse();
    return teller_.Say(Priority::kText, say::NothingTouched(mouse));
  }
  if (!trace.followed() && !leading_) return teller_.Say(Priority::kText, say::NothingFollowed());
  Take(lesson_event::Traced{Flags(stage_.trace().Measured())});
  if (!shown_) stage_.Restart();
}

void LearnSession::Where() {
  const std::optional<NearLetter> letter =
      LetterNear(stage_.session().felt(), poll_.newest().tip_P);
  const bool touching = poll_.newest().depth > 0;
  if (!letter || !letter->near) {
    teller_.Say(Priority::kText, say::TipBetween(touching));
  } else {
    teller_.Say(Priority::kText,
                say::TipAt(told() ? NameOf(course_, letter->name) : "", letter->line, touching));
  }
  teller_.Say(Priority::kText, Status());
}

std::string LearnSession::Status() const {
  const auto& lessons = course_.lessons;
  const Progress& progress = state_.progress;
  const auto lesson = std::find_if(lessons.begin(), lessons.end(), [&progress](const Lesson& one) {
    return one.id == progress.lesson;
  });
  if (lesson == lessons.end()) return say::NoLessonNow();
  return say::WhereInCourse(lesson->title, static_cast<std::size_t>(lesson - lessons.begin()) + 1,
                            lesson->optional ? 0 : LessonsInOrder(course_), progress.step + 1,
                            lesson->steps.size());
}

std::vector<std::string> LearnSession::StatusForTutor() const {
  const bool set = state_.overrule.size || state_.overrule.help || state_.overrule.mode;
  say::PushNow push{false, state_.mode, state_.help, set};
  const bool demonstrates = leading_ && state_.mode != GuidanceMode::kOff;
  push.led = led_by_tutor_ || (demonstrates && stage_.pushes());
  // the help of a demonstration is the leading itself: what was said of help comes behind it
  if (push.led && demonstrates) push.help = state_.overrule.help.value_or(-1);
  return {say::PageAndHelp(stage_.size(), push),
          say::LastTrials(course_, last_right_, last_wrong_)};
}

void LearnSession::Letter(LearnWord word) {
  if (!told()) return teller_.Say(Priority::kText, say::NotWhileAsked());
  const std::optional<NearLetter> letter =
      LetterNear(stage_.session().felt(), poll_.newest().tip_P);
  const bool far = !letter || (word == LearnWord::kLetter && !letter->near);
  if (far) return teller_.Say(Priority::kText, say::NoLetterHere());
  if (word == LearnWord::kLetter) {
    return teller_.Say(Priority::kText, say::LetterHere(NameOf(course_, letter->name)));
  }
  if (word == LearnWord::kWord) {
    return teller_.Say(Priority::kText, say::WordHere(NameOf(course_, letter->word)));
  }
  std::vector<std::string> names;
  for (const std::string& sign : CharactersOf(letter->word)) {
    names.emplace_back(NameOf(course_, sign));
  }
  teller_.Spell(say::Spelled(names), letter->word);
}

void LearnSession::Stop(bool by_tutor) {
  if (stopped_ && !stopped_by_tutor_) return teller_.Say(Priority::kText, say::AlreadyStopped());
  Pause(by_tutor);
  paused_ = false;
  teller_.Hush();
  teller_.Say(Priority::kImportant, say::Event(SafetyEvent::kStopped, stage_.pushes()));
  teller_.Play(Earcon::kSafetyStop);
  memory_.Note(Now(), "stop", by_tutor ? "tutor" : "learner");
}

}  // namespace moontrace
