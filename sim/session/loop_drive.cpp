#include "sim/session/loop_drive.h"

#include <chrono>
#include <memory>
#include <ostream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "lessons/guide/guidance.h"
#include "lessons/guide/guidance_path.h"
#include "sim/console/word_messages.h"
#include "sim/session/label_walk.h"
#include "sim/session/loop_messages.h"
#include "sim/session/loop_poll.h"
#include "sim/session/loop_words.h"
#include "sim/session/tip_words.h"
#include "sim/session/view_messages.h"
#include "sim/session/view_panels.h"
#include "sim/tutor/page_messages.h"
#include "textures/base/error.h"

namespace moontrace {

namespace {

constexpr int kPoll = 20;  ///< [ms]

/// A hand that is being led may ask in the meantime.
bool OnlyTells(LoopWord word) {
  return word == LoopWord::kWhere || word == LoopWord::kHelp || word == LoopWord::kNothing ||
         word == LoopWord::kRefused || word == LoopWord::kLabels;
}

/// Not of what lies under the hand, and never to wait for it.
bool IsOfForce(LoopWord word) {
  return word == LoopWord::kStop || word == LoopWord::kPause || word == LoopWord::kGo;
}

/// One session and what was last known of it.
class Driver : private LoopListener {
 public:
  Driver(LoopSession& session, const DriveOptions& options, Console& console)
      : session_(session),
        options_(options),
        console_(console),
        own_lines_(options.typed != nullptr ? nullptr : std::make_unique<LineReader>(console.in())),
        lines_(options.typed != nullptr ? *options.typed : *own_lines_),
        poll_(session.loop(), session.device()),
        walk_(session, [&session](std::size_t page) { session.TurnTo(page); }),
        labels_(session),
        spoken_(lines_.at_terminal()) {}

  /// False: nobody has said a word, or could.
  bool Run() {
    if (options_.view != nullptr) options_.view->SetPanel(LoopPanel());
    ShowModel();
    if (options_.companion != nullptr) SayAll(options_.companion->Begin(walk_));
    const auto begin = std::chrono::steady_clock::now();
    while (!quit_) {
      console_.CheckStop();
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
      if (options_.seconds && passed.count() >= *options_.seconds) break;
      Look();
      if (AwaitsLoop()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        continue;
      }
      LookAtWindow();
      HearElsewhere();
      if (quit_) break;  // what is typed from now on is for others
      if (const std::optional<std::string> line = lines_.Next(kPoll)) {
        spoken_ = true;
        if (options_.elsewhere != nullptr) options_.elsewhere->Typed(*line);
        Obey(*line);
      } else if (lines_.ended() && InputEndsIt()) {
        quit_ = true;
        console_.Remark(say::InputEnded());
      }
      console_.out().flush();
    }
    session_.loop().End();
    Look();
    return spoken_;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void Say(const std::string& line) {
    if (line.empty()) return;
    answer_.push_back(line);
    console_.Result(line);
    if (options_.elsewhere != nullptr) options_.elsewhere->Told(line);
    if (options_.view != nullptr) options_.view->ShowLine(line);
  }

  void SayAll(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) Say(line);
  }

  void Happens(const std::string& line) {
    if (line.empty()) return;
    console_.Happening(line);
    if (options_.view != nullptr) options_.view->ShowLine(line);
  }

  /// What nobody asked for is left out by --quiet, but not what takes the force away.
  void Report(const LoopEvent& event, const std::string& line) {
    const bool asked = event.kind == LoopEventKind::kBookmark ||
                       event.kind == LoopEventKind::kPageGone ||
                       (event.kind == LoopEventKind::kSafety && TakesForceAway(event.safety));
    if (line.empty()) return;
    if (asked) {
      answer_.clear();
      Say(line);
      return Answer();
    }
    Happens(line);
  }

  /// Nobody can say "quit" any more. Where the text itself was the input, no word was meant to
  /// come.
  bool InputEndsIt() const {
    return options_.input_ends && !options_.seconds && !session_.text_was_input();
  }

  /// What is said in the window is as if it were typed.
  void LookAtWindow() {
    ViewFeed* view = options_.view;
    if (view == nullptr) return;
    view->Hear([this](const ViewLine& line) { Obey(line.text); },
               [this](const std::string& notice) { console_.Remark(notice); });
    // nothing could move the tip again
    if (view->failed() && session_.device().mouse()) quit_ = true;
    if (!view->closed() || quit_) return;
    quit_ = true;
    console_.Happening(say::WindowClosed());
  }

  /// A sentence alone is an answer; before a word it announces what becomes of that.
  void HearElsewhere() {
    if (options_.elsewhere == nullptr) return;
    while (!quit_) {
      const std::optional<Elsewhere::Line> line = options_.elsewhere->Next(poll_.newest());
      if (!line) return;
      answer_.clear();
      Say(line->said);
      if (line->lies) {
        Buzz();
      } else if (line->word.empty()) {
        Answer();
      } else {
        Obey(line->word);
      }
    }
  }

  void Look() {
    poll_.Look(*this);
    if (options_.companion != nullptr) {
      answer_.clear();
      SayAll(options_.companion->Look(poll_.newest()));
      if (options_.companion->trembles()) Buzz();
      if (options_.companion->urgent()) Answer();
      quit_ = quit_ || options_.companion->ended();
    }
    if (const auto arrival = walk_.Arrived(poll_.newest())) {
      Say(arrival->sentence);
      LeadTo(*arrival);
      if (options_.companion != nullptr) options_.companion->Arrived(arrival->source);
    }
    if (const auto arrival = labels_.Arrived(poll_.newest())) {
      Say(arrival->sentence);
      way_ = arrival;
    }
    if (way_ && labels_.IsFree(poll_.newest())) {
      way_->tip_P = poll_.newest().tip_P;
      LeadTo(*std::exchange(way_, std::nullopt));
    }
    Happens(labels_.TouchedAnew(poll_.newest()));
    Happens(labels_.PressedAnew(poll_.newest()));
    if (pending_ && poll_.newest().page == session_.felt().number) {
      Obey(*std::exchange(pending_, std::nullopt));
    }
    if (led_ && (poll_.newest().guidance_done || Clock::now() > led_until_)) LetGo();
    ShowModel();
    if (options_.view != nullptr) options_.view->Look(session_.felt(), poll_);
  }

  /// Once, and again where another label is the page.
  void ShowModel() {
    if (options_.view == nullptr || shown_ == session_.view_model()) return;
    shown_ = session_.view_model();
    options_.view->ShowModel(shown_);
  }

  void Happened(const LoopEvent& event, const std::string& sentence) override {
    if (Taken(event)) return;
    if (event.kind == LoopEventKind::kSay) {
      answer_.clear();
      Say(WhereNow());
      Answer();
    }
    if (event.kind == LoopEventKind::kBookmark) {
      if (const auto place = LetterPlaceOf(session_.felt(), event.tip_P)) mark_ = place;
      if (options_.companion != nullptr && mark_) return Say(options_.companion->Marked(*mark_));
    }
    Report(event, sentence);
  }

  void Reported(const std::string& sentence, bool urgent) override {
    answer_.clear();
    Say(sentence);
    if (urgent) Answer();
  }

  /// Whether a press was for the companion.
  bool Taken(const LoopEvent& event) {
    const bool twice = event.kind == LoopEventKind::kBookmark;
    if (options_.companion == nullptr || (!twice && event.kind != LoopEventKind::kSay)) {
      return false;
    }
    Companion::Press press = options_.companion->Pressed(twice, event);
    if (!press.line.empty()) pending_ = std::move(press.line);
    return press.taken;
  }

  /// What was said since it was cleared goes to the companion.
  void Answer() {
    if (options_.companion == nullptr || answer_.empty() || quit_) return;
    if (options_.companion->Answered(answer_, poll_.newest())) Buzz();
  }

  /// A short tremble, without a push.
  void Buzz() {
    if (!session_.device().felt() || poll_.newest().stopped) return;
    constexpr std::chrono::milliseconds kLong{300};
    constexpr glm::dvec3 kFarOff{1, 1, 0};  // [m] off every page, so that all of it is off the way
    GuidancePlan plan;
    plan.mode = GuidanceMode::kCorridor;
    plan.gains = GuidanceTable::Shipped().GainsOf(plan.mode, kMostHelp);
    plan.path = MakeRecordedPath({0, 1}, {kFarOff, kFarOff + glm::dvec3(0.01, 0, 0)},
                                 session_.text().set.style.width);
    session_.loop().Guide(std::make_shared<const GuidancePlan>(std::move(plan)));
    led_until_ = Clock::now() + kLong;
    led_ = true;
  }

  void Stands(const LoopSnapshot& newest) override {
    if (options_.view == nullptr) return;
    options_.view->SetValues(LoopPanelValues(session_.text(), session_.form(), session_.tilt(),
                                             session_.felt().index,
                                             say::PanelState(newest.stopped, newest.depth > 0)));
  }

  void Felt(const LoopSample& sample) override {
    if (options_.sample) options_.sample(sample);
    if (options_.view != nullptr) options_.view->Add(sample);
  }

  std::string WhereNow() {
    return Where(session_.felt(), session_.device().pushes(), poll_.newest());
  }

  /// A label by its name or text goes before a place in the text, a piece of one behind it.
  std::string Lead(const PlaceCommand& command) {
    if (command.word == PlaceWord::kFind) {
      if (auto label = labels_.Find(command.text, false)) return *label;
      const std::string refusal = walk_.Go(command, poll_.newest());
      const auto label = refusal.empty() ? std::nullopt : labels_.Find(command.text, true);
      return label.value_or(refusal);
    }
    const std::string refusal = walk_.Go(command, poll_.newest());
    const bool back = command.word == PlaceWord::kReturn && !refusal.empty();
    return back ? labels_.Return().value_or(refusal) : refusal;
  }

  /// A hand that can be pushed is led there, until it has come or does not follow.
  void LeadTo(const PlaceWalk::Arrival& arrival) {
    if (!session_.device().felt() || poll_.newest().stopped) return;
    constexpr std::chrono::seconds kPatience{8};
    GuidancePlan plan;
    plan.mode = GuidanceMode::kBead;
    plan.gains = GuidanceTable::Shipped().GainsOf(plan.mode, kMostHelp);
    plan.path = PathTo(arrival, session_.text().set.style.width);
    led_until_ = Clock::now() + kPatience +
                 std::chrono::duration_cast<Clock::duration>(
                     std::chrono::duration<double>(plan.path->times.back()));
    session_.loop().Guide(std::make_shared<const GuidancePlan>(std::move(plan)));
    led_ = true;
  }

  void LetGo() {
    if (led_) session_.loop().Guide(nullptr);
    led_ = false;
    way_.reset();
  }

  void Turn(bool forward) {
    const std::size_t pages = session_.text().set.pages.size();
    Say(session_.Turn(forward) ? say::NowPage(session_.felt().index, pages)
                               : say::NoOtherPage(forward, pages));
  }

  void Resize(bool bigger) {
    if (!options_.sizes) return Say(say::SizeStays());
    try {
      session_.Resize(bigger, poll_.newest().tip_P);
      SaySize();
    } catch (const InputError& error) {
      Say(say::CannotResize(error.what()));
    }
  }

  void SaySize() {
    const Typeset& set = session_.text().set;
    Say(say::NowSize(set.style.size, session_.felt().index, set.pages.size()));
  }

  void Change(const PageCommand& command) {
    if (!options_.sizes) return Say(say::PageStaysWhileScored());
    try {
      if (command.word == PageWord::kSize) {
        session_.SetSize(command.value, poll_.newest().tip_P);
        return SaySize();
      }
      if (command.word == PageWord::kTilt) {
        session_.Tilt(command.value);
      } else {
        session_.SetForm(Changed(session_.form(), command), poll_.newest().tip_P);
      }
      Say(say::PageNow(command));
    } catch (const InputError& error) {
      Say(say::PageStays(error.what()));
    }
  }

  WordPlace words() const {
    return options_.companion == nullptr ? WordPlace::kLoop : options_.companion->words();
  }

  void Help(const std::string& word) {
    if (!word.empty()) {
      proposal_.MakeHelp(word, words());
      return Say(say::HelpWith(word, words()));
    }
    Say(say::NumberedWords(words()));
    Say(say::PageWordsHelp());
    if (options_.view == nullptr) return;
    Say(say::ViewWordsHelp());
    Say(say::ViewColoursHelp());
  }

  /// What lies there besides the text goes first: words are about the text.
  void Obey(const std::string& line) {
    if (options_.companion != nullptr && !IsOfForce(ReadLoopLine(line, words()).word) &&
        options_.companion->ClearPage()) {
      pending_ = line;
      return;
    }
    answer_.clear();
    ObeyWord(line);
    Answer();
  }

  /// Of what has no effect no event tells. The loop is asked for a stop in any case: what is known
  /// of it may be old.
  void Stop() {
    if (poll_.newest().stopped) Say(say::AlreadyStopped());
    Ask(true);
    session_.loop().Stop();
  }

  void GoOn() {
    if (!poll_.newest().stopped) return Say(say::NotStopped());
    Ask(false);
    session_.GoOn();
  }

  void Ask(bool stopped) {
    constexpr std::chrono::milliseconds kPatience{200};
    asked_stopped_ = stopped;
    asked_until_ = Clock::now() + kPatience;
  }

  /// Whether the next word is to wait, so that it meets what the last one did. A loop that stands
  /// still is not waited for.
  bool AwaitsLoop() {
    const bool known = asked_stopped_ == poll_.newest().stopped || Clock::now() > asked_until_;
    if (known) asked_stopped_.reset();
    return asked_stopped_.has_value();
  }

  void ObeyWord(const std::string& given) {
    const std::string line = proposal_.Taken(given);
    if (options_.view != nullptr) {
      if (const std::optional<std::string> done = options_.view->Obey(line)) return Say(*done);
    }
    const LoopLine said = ReadLoopLine(line, words());
    if (!OnlyTells(said.word)) LetGo();  // the hand is to do something else now
    if (options_.companion != nullptr) {
      if (const auto lines = options_.companion->Obey(line, poll_.newest())) return SayAll(*lines);
    }
    switch (said.word) {
      case LoopWord::kStop:
      case LoopWord::kPause:
        return Stop();
      case LoopWord::kGo:
        return GoOn();
      case LoopWord::kBigger:
        return Resize(true);
      case LoopWord::kSmaller:
        return Resize(false);
      case LoopWord::kNext:
        return Turn(true);
      case LoopWord::kBack:
        return Turn(false);
      case LoopWord::kWhere:
        Say(labels_.Touched(poll_.newest()));
        return Say(WhereNow());
      case LoopWord::kMark:
        return Say(WayToMark(session_, mark_, poll_.newest()));
      case LoopWord::kPage:
        return Change(said.page);
      case LoopWord::kPlace:
        return Say(Lead(said.place));
      case LoopWord::kLabels:
        return SayAll(labels_.List());
      case LoopWord::kNextLabel:
        return Say(labels_.Next());
      case LoopWord::kQuit:
        quit_ = true;
        return;
      case LoopWord::kHelp:
        return Help(said.text);
      case LoopWord::kNothing:
        return;
      case LoopWord::kRefused:
        proposal_.Make(said.meant);
        return Say(said.refusal);
    }
  }

  LoopSession& session_;
  const DriveOptions& options_;
  Console& console_;
  std::unique_ptr<LineReader> own_lines_;  ///< none: they are another's
  LineReader& lines_;
  LoopPoll poll_;
  PlaceWalk walk_;
  LabelWalk labels_;
  std::optional<PlaceWalk::Arrival> way_;  ///< to a label, that the hand is to be led
  std::shared_ptr<const ViewModel> shown_;
  bool led_ = false;
  Clock::time_point led_until_;
  std::optional<bool> asked_stopped_;  ///< by the last word, and not yet so
  Clock::time_point asked_until_;
  Proposal proposal_;
  std::optional<LetterPlace> mark_;
  std::vector<std::string> answer_;     ///< said since the last word
  std::optional<std::string> pending_;  ///< a word that waits for the page
  bool spoken_;                         ///< a line has come, or may come from a terminal
  bool quit_ = false;
};

}  // namespace

bool Drive(LoopSession& session, const DriveOptions& options, Console& console) {
  return Driver(session, options, console).Run();
}

void RequireDevice(LoopSession& session) {
  if (session.loop().lost()) throw LackError(say::EndedLost(session.loop().WhyLost()));
}

void SayBeginning(const LoopSession& session, Console& console) {
  const TextRequest& request = session.request();
  const LiveDevice& device = session.device();
  const std::string& text = session.text().text;
  const TextOptions& given = request.text;
  const bool chosen = given.text || !given.file.empty() || text != request.default_text;
  if (!request.book) console.Happening(say::OnThePage(text, chosen));
  console.Happening(say::LoopBegins(device.simulated() ? "simulated stylus" : device.name()));
  const Typeset& set = session.text().set;
  if (!device.simulated() && !device.mouse()) {
    console.Happening(say::SetFor(set.page, set.pages.size()));
  }
  if (device.scale() != 1) console.Happening(say::Scaled(device.scale()));
  const double usual = request.feel.scene.coupling_stiffness;
  if (device.pushes() && session.coupling_stiffness() < usual) {
    console.Remark(say::SofterThanUsual(session.coupling_stiffness() / usual));
  }
  if (device.mouse()) {
    console.Happening(say::MouseIsSeen());
  } else if (!device.simulated() && !device.pushes()) {
    console.Happening(say::NoMotors());
  }
  console.Remark(session.text_was_input() ? say::CannotSpeak() : say::HowToSpeak());
  console.out().flush();
}

}  // namespace moontrace
