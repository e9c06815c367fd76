#include "sim/study/course_run.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>
#include <variant>

#include "lessons/course/lesson_items.h"
#include "lessons/guide/guidance.h"
#include "lessons/guide/guidance_path.h"
#include "lessons/guide/guidance_table.h"
#include "lessons/progress/answer.h"
#include "lessons/progress/learning.h"
#include "lessons/progress/mastery.h"
#include "sim/study/simulated_learner.h"
#include "sim/trial/trial.h"
#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

using lesson_action::Sentence;

constexpr std::int64_t kDay = std::int64_t{24} * 60 * 60;
constexpr double kBetweenTrials = 4;   // to listen and to come back to the page [s]
constexpr double kAnswering = 1;       // to say what it was [s]
constexpr int kGreatestDays = 400;     // a course that takes longer is not finished
constexpr int kIdleLimit = 200;        // events without a trial after which it is stuck
constexpr int kTaughtTimes = 1;        // explorations of an item that was named, at each size
constexpr std::int64_t kPause = 3600;  // between two sessions at least, in records [s]; ours

/// Pages, each made once and kept.
class PageShelf {
 public:
  const ItemPage& Page(const lesson_action::Show& show) {
    auto& page = pages_[{show.text, show.script, show.grade, show.size}];
    if (!page) {
      auto script = scripts_.find(show.script);
      if (script == scripts_.end()) {
        script = scripts_.emplace(show.script, FindScript(show.script)).first;
      }
      page = std::make_unique<ItemPage>(
          SetItem(show.text, script->second, show.size, {show.grade, 1}));
    }
    return *page;
  }

 private:
  std::map<std::string, Script> scripts_;
  std::map<std::tuple<std::string, std::string, double, double>, std::unique_ptr<ItemPage>> pages_;
};

class CourseRun {
 public:
  explicit CourseRun(const CourseRunSetup& setup)
      : setup_(setup),
        table_(GuidanceTable::Shipped()),
        learner_(setup.learner, ShippedHand(), setup.seed),
        time_(setup.begin) {
    result_.progress = LearnAll(*setup.course, setup.history);
    if (setup.history.empty()) return;
    time_ = std::max(time_, result_.progress.last + kDay);
    Recall();
    before_ = learner_.seconds();
  }

  CourseRunResult Run() {
    const int most = setup_.days > 0 ? setup_.days : kGreatestDays;
    while (!result_.done && !result_.stuck && result_.days < most) {
      ++result_.days;
      const std::int64_t began = time_;
      Session();
      time_ = std::max(time_ + 1, began + kDay);
      learner_.Wait(static_cast<double>(time_ - began) / static_cast<double>(kDay));
    }
    result_.seconds = learner_.seconds() - before_;
    return std::move(result_);
  }

 private:
  /// What the learner remembers is told from its records, as a person's place is, whatever run they
  /// come from: days pass between sessions, each trace teaches the hand again, and what was named
  /// is remembered as it feels.
  void Recall() {
    std::int64_t began = setup_.history.front().time, last = began;
    const auto wait_until = [&](std::int64_t time) {
      learner_.Wait(static_cast<double>(std::max<std::int64_t>(0, time - began)) /
                    static_cast<double>(kDay));
      began = time;
    };
    for (const Trial& trial : setup_.history) {
      if (setup_.check) setup_.check();
      if (trial.time - last >= kPause || trial.time < began) wait_until(trial.time);
      last = trial.time;
      RecallTrial(trial);
    }
    wait_until(time_);
  }

  void RecallTrial(const Trial& trial) {
    const Course& course = *setup_.course;
    const ItemPair pair = PairOf(trial.item);
    const auto same_size = [&trial](double size) { return SameSize(size, trial.size); };
    if (!HasItem(course, pair.first) ||
        std::none_of(course.sizes.begin(), course.sizes.end(), same_size)) {
      return;  // of another course, or from a tutor's hand
    }
    const bool same = !pair.second.empty() && SameSaid(trial.answer).has_value();
    if (trial.kind == StepKind::kTrace || trial.kind == StepKind::kDemonstrate) {
      if (!(trial.duration > 0)) return;  // skipped
      learner_.Relive(pair.first, FeltIn(trial, pair.first));
      int& times = felt_about_[{pair.first, trial.size}];
      if (times++ < kTaughtTimes) RecallShape(pair.first, trial.size);
    } else if (trial.kind == StepKind::kRecognise && !same) {
      RecallShape(pair.first, trial.size);
    }
  }

  /// The error that was felt in a trace, which no record holds: what of the aim was wrong then, as
  /// far as the force on the tip was not a push that took the error away. Ours; traces of four days
  /// of the shipped course have it within 0.15 in the mean.
  double FeltIn(const Trial& trial, const std::string& item) const {
    const double pushed =
        trial.mean_force > 0 ? std::clamp(trial.mean_guidance / trial.mean_force, 0.0, 1.0) : 0;
    return (1 - pushed) * learner_.AimErrorShare(item, trial.guided());
  }

  /// How an item feels at a size is felt anew, once.
  void RecallShape(const std::string& item, double size) {
    lesson_action::Show show;
    const Lesson* home = HomeOf(*setup_.course, item);
    show.text = item;
    show.script = home != nullptr && !home->script.empty() ? home->script : setup_.course->script;
    show.grade = home != nullptr ? home->grade : 1;
    show.size = size;
    const auto [shape, fresh] = recalled_.try_emplace({item, size});
    if (fresh) shape->second = learner_.Feel(shelf_.Page(show));
    learner_.shapes().Remember(item, shape->second, learner_.day());
  }

  /// From the start until a break is proposed or the course ends.
  void Session() {
    state_ = StartLesson(*setup_.course, std::move(result_.progress),
                         SeedOf(setup_.seed, "day" + std::to_string(result_.days)));
    state_.simulated = true;
    rest_ = false;
    idle_ = 0;
    Send(lesson_event::Begin{});
    while (!rest_ && !result_.done && !result_.stuck) {
      if (setup_.check) setup_.check();
      Answer();
      Send(lesson_event::Tick{});
    }
    result_.progress = std::move(state_.progress);
  }

  template <typename What>
  void Send(const What& what) {
    LessonTurn turn = Advance(*setup_.course, std::move(state_), Event{time_, what});
    state_ = std::move(turn.state);
    for (const Action& action : turn.actions) {
      std::visit([this](const auto& each) { this->Hear(each); }, action);
    }
    if (++idle_ > kIdleLimit) result_.stuck = true;
  }

  void Hear(const lesson_action::Say& say) {
    switch (say.sentence) {
      case Sentence::kTraceIt:
      case Sentence::kLedAlong:
        named_ = say.text;
        break;
      case Sentence::kAskName:
      case Sentence::kAskPick:
      case Sentence::kAskSame:
        asked_ = say;
        break;
      case Sentence::kRight:
      case Sentence::kWrong:
      case Sentence::kTold:
        if (asked_.sentence != Sentence::kAskSame) Remember(say.text);
        break;
      case Sentence::kNotAnAnswer:
        not_understood_ = true;
        break;
      case Sentence::kBreak:
        rest_ = true;
        break;
      case Sentence::kCourseDone:
        result_.done = true;
        break;
      default:
        break;
    }
    if (setup_.news) setup_.news(say, result_.days);
  }
  void Hear(const lesson_action::Show& show) { show_ = show; }
  void Hear(const lesson_action::Push& push) { push_ = push; }
  void Hear(const lesson_action::Keep& keep) {
    ++result_.trials;
    idle_ = 0;
    result_.item = keep.trial.item;
    const std::string where = keep.trial.lesson + "/" + std::to_string(keep.trial.step);
    if (where != where_) step_trials_ = 0;
    where_ = where;
    if (++step_trials_ > setup_.step_limit) result_.stuck = true;
    if (setup_.keep) setup_.keep(keep.trial);
  }
  void Hear(const lesson_action::Await& await) { await_ = await; }

  void Answer() {
    switch (await_) {
      case lesson_action::Await::kTrace:
        Trace();
        break;
      case lesson_action::Await::kAnswer:
        Name();
        break;
      case lesson_action::Await::kNext:
        Send(lesson_event::Said{lesson_event::Word::kNext});
        break;
      case lesson_action::Await::kEnd:
        if (!result_.done) result_.stuck = true;
        break;
    }
  }

  void Pass(double seconds) { time_ += std::max<std::int64_t>(1, std::llround(seconds)); }

  void Trace() {
    const ItemPage& page = shelf_.Page(show_);
    GuidancePlan plan{push_.mode, table_.GainsOf(push_.mode, push_.help),
                      MakeGuidancePath(page.strokes)};
    plan.gains.bead_speed *= push_.speed;
    const bool pushed = push_.mode != GuidanceMode::kOff && push_.help > 0;
    const TracedItem traced = learner_.Trace(named_, page, pushed ? &plan : nullptr);
    Pass(traced.measured.duration + kBetweenTrials);
    // An item that was named is also explored once, so that it is recognised later.
    int& times = felt_about_[{named_, show_.size}];
    if (times < kTaughtTimes) {
      ++times;
      const double before = learner_.seconds();
      felt_ = learner_.Feel(page);
      Pass(learner_.seconds() - before);
      Remember(named_);
    }
    Send(lesson_event::Traced{traced.measured});
  }

  void Name() {
    lesson_event::Answered answer;
    if (not_understood_) {  // it answers with something that it was taught
      answer.text = learner_.shapes().NameTaught(felt_, learner_.day(), learner_.Guess()).label;
      answer.latency = kAnswering;
    } else {
      const double before = learner_.seconds();
      felt_ = learner_.Feel(shelf_.Page(show_));
      answer.latency = learner_.seconds() - before + kAnswering;
      answer.text = WhatItWas();
    }
    not_understood_ = false;
    answer.measured.duration = answer.latency;
    Pass(answer.latency + kBetweenTrials);
    Send(answer);
  }

  std::string WhatItWas() {
    Recogniser& shapes = learner_.shapes();
    const std::uint64_t guess = learner_.Guess();
    if (asked_.sentence == Sentence::kAskSame) {
      return shapes.AreSame(felt_, learner_.day(), guess) ? "same" : "different";
    }
    if (asked_.sentence == Sentence::kAskPick) {
      return shapes.Pick(felt_, asked_.text, asked_.other, learner_.day(), guess).label;
    }
    return shapes.Name(felt_, learner_.day(), guess).label;
  }

  void Remember(const std::string& item) {
    learner_.shapes().Remember(item, felt_, learner_.day());
    felt_.clear();
  }

  const CourseRunSetup& setup_;
  GuidanceTable table_;
  SimulatedLearner learner_;
  PageShelf shelf_;
  std::int64_t time_ = 0;
  LessonState state_;
  CourseRunResult result_;

  lesson_action::Show show_;
  lesson_action::Push push_;
  lesson_action::Say asked_;
  lesson_action::Await await_ = lesson_action::Await::kNext;
  std::string named_;  ///< the item that was named last
  FeltShape felt_;     ///< what was felt last and not yet named
  std::map<std::pair<std::string, double>, int> felt_about_;
  std::map<std::pair<std::string, double>, FeltShape> recalled_;
  double before_ = 0;  ///< work of the hand that was recalled [s]
  bool rest_ = false, not_understood_ = false;
  int idle_ = 0;
  std::size_t step_trials_ = 0;
  std::string where_;  ///< lesson and step
};

}  // namespace

CourseRunResult RunCourse(const CourseRunSetup& setup) { return CourseRun(setup).Run(); }

}  // namespace moontrace
