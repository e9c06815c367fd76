#include "sim/learn/learn_session.h"

#include <algorithm>
#include <ctime>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "sim/console/line_wrap.h"
#include "sim/learn/learn_messages.h"
#include "sim/session/loop_messages.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

using lesson_action::Await;

constexpr double kTickEvery = 10;     ///< the machine hears of time [s]
constexpr double kSpeaksWithin = 2;   ///< a device that is back has said where its tip is [s]
constexpr int kRoundsTold = 3;        ///< of the program's hand around one sign
constexpr double kObeysWithin = 0.3;  ///< the loop has taken a stop or go by then [s]

bool IsNumber(const std::string& item) {
  return !item.empty() && item.find_first_not_of("0123456789") == std::string::npos;
}

bool IsSize(lesson_action::Sentence sentence) {
  using lesson_action::Sentence;
  return sentence == Sentence::kSizeNow || sentence == Sentence::kLargestSize ||
         sentence == Sentence::kSmallestSize;
}

}  // namespace

LearnSession::LearnSession(const LearnParts& parts, std::uint64_t seed, say::HelpLines help)
    : course_(parts.course),
      memory_(parts.memory),
      stage_(parts.stage),
      teller_(parts.teller),
      help_(std::move(help)),
      state_(StartLesson(course_, memory_.Recall(course_), seed)),
      poll_(stage_.session().loop(), stage_.session().device()),
      walk_(stage_.session(), [this](std::size_t page) { stage_.TurnTo(page); }),
      looked_(Clock::now()),
      ordered_(looked_),
      ticked_(looked_) {}

std::int64_t LearnSession::Now() const { return static_cast<std::int64_t>(std::time(nullptr)); }

Asked LearnSession::asked() const {
  if (asks_text_) return Asked::kText;
  if (asks_sign_) return Asked::kName;  // so that 1 is still the word stop
  if (await_ != Await::kAnswer) return Asked::kNothing;
  if (state_.question == Question::kSame) return Asked::kSame;
  return AsksNumbers() ? Asked::kNumber : Asked::kName;
}

/// Of two that were named one is a number, or numbers are known.
bool LearnSession::AsksNumbers() const {
  if (state_.question == Question::kPick) return IsNumber(state_.item) || IsNumber(state_.mate);
  const auto& items = state_.progress.items;
  return std::any_of(state_.named.begin(), state_.named.end(), IsNumber) ||
         std::any_of(items.begin(), items.end(), [](const auto& item) {
           return item.second.introduced && IsNumber(item.first);
         });
}

void LearnSession::Begin() {
  Take(lesson_event::Begin{});
  teller_.EndTurn();
}

/// What goes into a trial beside what was measured.
Trial LearnSession::Flags(Trial measured) const {
  measured.simulated = stage_.simulated();
  const PageForm& form = stage_.form();
  measured.scaled = stage_.simulated() || !stage_.pushes() || stage_.shrunk() ||
                    stage_.session().device().scale() != 1 || form.depth != 1 || form.width != 1;
  return measured;
}

void LearnSession::Take(decltype(Event::what) what) {
  shown_ = false;
  const Trial flags = Flags({});
  state_.scaled = flags.scaled;
  state_.simulated = flags.simulated;
  state_.held = !stage_.lifts();
  LessonTurn turn = Advance(course_, std::move(state_), {Now(), std::move(what)});
  state_ = std::move(turn.state);
  // what is told as done must be on disk first
  for (const Action& action : turn.actions) {
    if (const auto* keep = std::get_if<lesson_action::Keep>(&action)) Do(*keep);
  }
  for (const Action& action : turn.actions) {
    if (std::holds_alternative<lesson_action::Keep>(action)) continue;
    std::visit([this](const auto& one) { Do(one); }, action);
  }
  if (sized_) Tell(*std::exchange(sized_, std::nullopt));  // nothing was shown
  const bool unfelt = !stage_.pushes() || stage_.simulated();
  if (shown_ && await_ == Await::kAnswer && unfelt) SayAskedPath();
}

void LearnSession::Do(const lesson_action::Keep& keep) {
  const std::size_t before = memory_.held_back();
  const std::string why = memory_.Keep(keep.trial, stage_.trace().track());
  if (!keep.trial.item.empty()) ++kept_;
  const StepKind kind = keep.trial.kind;
  const bool judged =
      kind == StepKind::kTrace || kind == StepKind::kRecognise || kind == StepKind::kTest;
  if (!keep.trial.item.empty() && judged) {
    (keep.trial.right ? last_right_ : last_wrong_) = keep.trial;
  }
  if (keep.trial.kind == StepKind::kTrace) missed_ = keep.trial.right ? "" : keep.trial.item;
  if (!why.empty()) {
    teller_.Say(Priority::kMessage, say::NotKept(why));
  } else if (before > 0) {
    teller_.Say(Priority::kText, say::KeptNow(before));
  }
}

/// Of a size the page has the last word: it may have no room.
void LearnSession::Do(const lesson_action::Say& sentence) {
  if (IsSize(sentence.sentence)) {
    sized_ = sentence;
  } else {
    Tell(sentence);
  }
}

void LearnSession::TellSize(const lesson_action::Show& show) {
  const auto asked = std::exchange(sized_, std::nullopt);
  if (!stage_.shrunk()) {
    no_room_ = 0;
    if (asked) Tell(*asked);
    return;
  }
  const bool known = std::exchange(no_room_, show.size) == show.size;
  if (known && !asked) return;  // page after page
  if (!asked) return teller_.Say(Priority::kText, say::NoRoomFor(show.size, stage_.size()));
  const double wanted = asked->number > 0 ? 1e-3 * asked->number : show.size;
  teller_.Say(Priority::kText, say::SizeHasNoRoom(wanted, stage_.size()));
}

/// Of the program's own hand, which traces a sign until it is left, the first rounds are told.
bool LearnSession::GoesOnUnsaid(const lesson_action::Say& sentence) {
  using lesson_action::Sentence;
  if (!stage_.simulated()) return false;
  switch (sentence.sentence) {
    case Sentence::kTraceIt: {
      if (in_full_) rounds_.clear();
      const bool known = std::any_of(rounds_.begin(), rounds_.end(),
                                     [](const auto& sign) { return sign.second > kRoundsTold; });
      unsaid_ = ++rounds_[sentence.text] > kRoundsTold;
      if (unsaid_ && !known) teller_.Say(Priority::kText, say::TracesOn());
      return unsaid_;
    }
    case Sentence::kProbe:
    case Sentence::kTraceGood:
    case Sentence::kTraceBad:
      return unsaid_;
    default:
      rounds_.clear();
      unsaid_ = false;
      return false;
  }
}

void LearnSession::Tell(const lesson_action::Say& sentence) {
  if (GoesOnUnsaid(sentence)) return;
  std::string text;
  if (stage_.simulated()) text = say::DemonstrationSentence(course_, sentence);
  const bool unled = sentence.sentence == lesson_action::Sentence::kLedAlong &&
                     !stage_.simulated() && !stage_.pushes();
  if (unled) return;  // its way is told in words
  if (text.empty()) text = voice_.Words(course_, sentence, memory_.brief(), in_full_);
  for (const std::string& line : Sentences(text)) {
    teller_.Say(PriorityOf(sentence.sentence), OneLine(line, 1000));
  }
  if (const auto earcon = EarconOf(sentence.sentence)) teller_.Play(*earcon);
}

void LearnSession::Do(const lesson_action::Show& show) {
  teller_.Flush();
  try {
    stage_.Show(show);
    TellSize(show);
  } catch (const InputError& error) {
    sized_.reset();
    teller_.Say(Priority::kText, say::CannotShow(show.told ? show.text : "", error.what()));
  }
  shown_ = true;
  leading_ = led_by_tutor_ = false;
  felt_ = 0;
}

void LearnSession::Do(const lesson_action::Push& push) {
  stage_.Push(push);
  led_by_tutor_ = false;
  leading_ = push.demonstrate;
  if (leading_ && !stage_.pushes() && !stage_.simulated()) SayPath();
}

void LearnSession::Do(Await await) {
  // what is asked now is what yes answers
  if (await == Await::kAnswer && await_ != await) proposal_.Make({});
  await_ = await;
  if (await == Await::kEnd) over_ = true;
}

/// Where nothing can lead the hand, words do.
void LearnSession::SayPath() {
  teller_.Say(Priority::kText, say::WayInWords(say::Called(course_, state_.item)));
  for (const std::string& line : say::PathInWords(stage_.trace().strokes())) {
    teller_.Say(Priority::kText, line);
  }
}

/// Likewise, of what is asked: without its name.
void LearnSession::SayAskedPath() {
  std::map<std::size_t, std::vector<IntendedStroke>> signs;
  for (const IntendedStroke& stroke : stage_.trace().strokes()) {
    signs[stroke.glyph].push_back(stroke);
  }
  std::size_t number = 0;
  for (const auto& [glyph, strokes] : signs) {
    teller_.Say(Priority::kText, say::AskedWayInWords(++number, signs.size()));
    for (const std::string& line : say::PathInWords(strokes)) {
      teller_.Say(Priority::kText, line);
    }
  }
}

void LearnSession::Pause(bool by_tutor) {
  stage_.session().loop().Stop();
  ordered_ = Clock::now();
  stopped_by_tutor_ = by_tutor && (!stopped_ || stopped_by_tutor_);
  stopped_ = paused_ = true;
}

bool LearnSession::GoOn(bool by_tutor) {
  if (!stopped_ || (by_tutor && !stopped_by_tutor_)) return false;
  stage_.GoOn();
  ordered_ = Clock::now();
  stopped_ = false;
  return true;
}

void LearnSession::Lead(std::shared_ptr<const GuidancePath> path) {
  stage_.Lead(std::move(path), state_.speed);
  led_by_tutor_ = true;
}

void LearnSession::Look() {
  const Clock::time_point now = Clock::now();
  passed_ = std::chrono::duration<double>(now - looked_).count();
  looked_ = now;
  poll_.Look(*this);
  LookAtPlace();
  LookAtTrace();
  if (std::chrono::duration<double>(now - ticked_).count() >= kTickEvery) {
    ticked_ = now;
    Take(lesson_event::Tick{});
  }
  teller_.EndTurn();
}

/// The state of the loop tells, not its events: a button's stop differs from a word's in nothing
/// but that it has not been told yet.
void LearnSession::LookAtStop() {
  const LoopSnapshot& newest = poll_.newest();
  const double since = std::chrono::duration<double>(Clock::now() - ordered_).count();
  if (newest.stopped == stopped_ || since < kObeysWithin) return;
  stopped_ = newest.stopped;
  stopped_by_tutor_ = paused_ = false;
  if (!stopped_) {
    return teller_.Say(Priority::kText, say::Event({LoopEventKind::kWentOn}, stage_.pushes()));
  }
  teller_.Hush();
  teller_.Say(Priority::kImportant, say::Event(SafetyEvent::kStopped, stage_.pushes()));
  teller_.Play(Earcon::kSafetyStop);
  memory_.Note(Now(), "stop", "button");
}

void LearnSession::Happened(const LoopEvent& event, const std::string& sentence) {
  const bool safety = event.kind == LoopEventKind::kSafety;
  if (safety && event.safety == SafetyEvent::kStopped) return;  // LookAtStop
  if (event.kind == LoopEventKind::kWentOn) return;
  // the program's hand runs on while all rests, held by nothing
  if (safety && stopped_ && stage_.simulated()) return;
  if (event.kind == LoopEventKind::kSay) return Where();
  if (event.kind == LoopEventKind::kBookmark) return EndTrace();
  if (event.kind == LoopEventKind::kDeviceBack) back_ = true;
  if (safety && event.safety == SafetyEvent::kDeviceLost) {
    GoAway(sentence);
  } else if (safety && TakesForceAway(event.safety)) {
    teller_.Say(Priority::kImportant, sentence);
  } else {
    teller_.Happening(Priority::kText, sentence);
  }
}

void LearnSession::GoAway(const std::string& sentence) {
  teller_.Say(Priority::kImportant, sentence);
  if (stage_.trace().touched()) teller_.Say(Priority::kText, say::LostTrial());
  if (!mend_told_) teller_.Say(Priority::kText, say::MendDevice(stage_.kind()));
  mend_told_ = away_ = true;
  back_ = led_by_tutor_ = false;
  there_ = 0;
  stage_.LetGo();
  felt_ = 0;
}

/// What is shown begins anew.
void LearnSession::ComeBack() {
  away_ = false;
  stage_.LetGo();
  felt_ = 0;
  teller_.Say(Priority::kText, Awaited());
}

/// It is back once it says where the tip is. One that is there and says nothing keeps nobody
/// waiting: what is to be said of it, the loop says.
void LearnSession::LookAtDevice(const LoopSnapshot& newest) {
  if (!away_) return;
  there_ = newest.present ? there_ + passed_ : 0;
  if (newest.present && (back_ || there_ >= kSpeaksWithin)) ComeBack();
}

void LearnSession::Reported(const std::string& sentence, bool urgent) {
  teller_.Say(urgent ? Priority::kImportant : Priority::kText, sentence);
}

/// What was felt counts only where nothing stopped it: that is known before the samples come.
void LearnSession::Stands(const LoopSnapshot& newest) {
  LookAtStop();
  LookAtDevice(newest);
  if (!stopped_ && newest.present) felt_ += passed_;
}

void LearnSession::Felt(const LoopSample& sample) { stage_.Add(sample, !stopped_ && !away_); }

/// A hand that is led has come to the end, a simulated one has been round the page, or one that
/// follows has covered enough and is lifted.
void LearnSession::LookAtTrace() {
  const LoopSnapshot& newest = poll_.newest();
  if (away_) return;
  const bool led = newest.guided && newest.guidance_done;
  const LearnTrace& trace = stage_.trace();
  if (led_by_tutor_) {
    if (led) stage_.LetGo();
    led_by_tutor_ = !led;
    return;
  }
  if (await_ != Await::kTrace || stopped_) return;
  const bool leads = leading_ && stage_.pushes();
  if (leads && led && !trace.touched()) {
    teller_.Say(Priority::kText, say::NothingTouched(false));
    return stage_.LetGo();  // once more
  }
  const bool round = stage_.simulated() && trace.duration() >= stage_.session().round();
  if (!trace.touched()) return;
  if (round || (leads ? led : trace.Ended(course_.mastery.coverage))) EndTrace();
}

std::size_t LearnSession::End() {
  stage_.session().loop().End();
  teller_.Say(Priority::kText, poll_.Repeated());
  const std::size_t lost = memory_.KeepRest();
  const auto& items = state_.progress.items;
  const auto sure =
      std::count_if(items.begin(), items.end(), [](const auto& item) { return item.second.sure; });
  teller_.Say(Priority::kMessage, say::SessionEnded(kept_, static_cast<std::size_t>(sure)));
  teller_.EndTurn();
  return lost;
}

}  // namespace moontrace
