// What is shown now: page, push and the question about it.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "lessons/course/lesson_items.h"
#include "lessons/guide/fading.h"
#include "lessons/progress/item_choice.h"
#include "lessons/progress/lesson_turn.h"
#include "lessons/progress/mastery.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

using lesson_action::Await;
using lesson_action::Sentence;

bool IsAsked(StepKind task) { return task == StepKind::kRecognise || task == StepKind::kTest; }

ItemProgress ProgressOf(const Turn& turn, const std::string& item) {
  const auto found = turn.state.progress.items.find(item);
  return found != turn.state.progress.items.end() ? found->second : ItemProgress{};
}

/// The mate of a pair: the course's if the learner knows it, otherwise another known one of the
/// step, the course's, any known one; empty: none.
std::string MateOf(Turn& turn, const std::string& item) {
  const auto named = turn.course.mates.find(item);
  const bool has_mate = named != turn.course.mates.end() && named->second != item &&
                        HasItem(turn.course, named->second);
  if (has_mate && IsIntroduced(turn, named->second)) return named->second;
  const auto any_of = [&](const std::vector<std::string>& texts) {
    std::vector<std::string> others;
    for (const std::string& text : texts) {
      if (text != item && IsIntroduced(turn, text)) others.push_back(text);
    }
    return others.empty() ? std::string() : others[NextRandom(turn.state.random) % others.size()];
  };
  std::string of_step = any_of(ItemsOf(*LessonNow(turn), *StepNow(turn)));
  if (!of_step.empty()) return of_step;
  if (has_mate) return named->second;
  std::vector<std::string> known;
  for (const auto& [text, progress] : turn.state.progress.items) known.push_back(text);
  return any_of(known);
}

/// Chooses the second of two, and which is shown.
void MakePair(Turn& turn) {
  LessonState& state = turn.state;
  if (state.question == Question::kName) return;
  state.mate = MateOf(turn, state.item);
  const bool heads = (NextRandom(state.random) & 1) != 0;
  if (state.question == Question::kSame) {
    if (heads || state.mate.empty()) state.mate = state.item;
  } else if (state.mate.empty()) {
    state.question = Question::kName;
  } else if (heads && IsIntroduced(turn, state.mate)) {
    std::swap(state.item, state.mate);
  }
}

/// Whether the next trace of the item is without help by plan. In a block of traces one in
/// `probe_every` is; while it is to be recognised all are, but for one after a bad one.
bool IsProbe(const Turn& turn, const ItemProgress& item) {
  const Step* step = StepNow(turn);
  if (step != nullptr && step->kind != StepKind::kTrace) {
    const MasteryRule& rule = turn.course.mastery;
    const bool bad = !item.coverages.empty() && (item.coverages.back() < rule.coverage ||
                                                 item.errors.back() > rule.error_widths);
    return !bad || item.guided_run > 0;
  }
  return item.guided_run + 1 >= std::max(1, turn.course.fade.probe_every);
}

/// Size of letters to explore or read: the largest at which one of them is still worked on.
double TextSize(const Turn& turn, const std::string& text) {
  std::size_t place = LastSize(turn.course);
  bool known = false;
  for (const auto& [item, progress] : turn.state.progress.items) {
    if (!progress.introduced || text.find(item) == std::string::npos) continue;
    place = std::min(place, progress.size_step);
    known = true;
  }
  return SizeAt(turn.course, known ? place : 0);
}

/// What lies on a page to explore or to read: the learner's own text or the step's.
std::string TextNow(const Turn& turn) {
  if (!turn.state.own_text.empty()) return turn.state.own_text;
  const Step* step = StepNow(turn);
  return step != nullptr ? step->text : std::string();
}

/// Push by the rules and what overrules them. Nothing pushes while something is recognised.
lesson_action::Push PushOf(const Turn& turn) {
  const LessonState& state = turn.state;
  lesson_action::Push push;
  push.speed = state.speed;
  const auto mode = state.overrule.mode;
  if (IsAsked(state.task)) return push;
  if (state.task == StepKind::kDemonstrate) {
    push.demonstrate = true;
    push.mode = mode == GuidanceMode::kOff ? GuidanceMode::kOff : GuidanceMode::kBead;
    push.help = push.mode == GuidanceMode::kOff ? 0 : kMostHelp;
    return push;
  }
  push.help = state.probe ? 0 : HelpByRules(turn);
  push.mode = push.help > 0 ? mode.value_or(GuidanceMode::kAttract) : GuidanceMode::kOff;
  if (push.mode == GuidanceMode::kOff) push.help = 0;
  return push;
}

void Push(Turn& turn) {
  const lesson_action::Push push = PushOf(turn);
  turn.state.mode = push.mode;
  turn.state.help = push.help;
  turn.actions.emplace_back(push);
}

Await AwaitOf(StepKind task) {
  if (IsAsked(task)) return Await::kAnswer;
  return task == StepKind::kExplore || task == StepKind::kRead ? Await::kNext : Await::kTrace;
}

/// Whether what is shown is asked for by the step, not a review, practice for a test, or known from
/// before.
bool IsOfStep(const Turn& turn) {
  const Lesson* lesson = LessonNow(turn);
  const Step* step = StepNow(turn);
  if (lesson == nullptr || step == nullptr || turn.state.review) return false;
  if (step->kind == StepKind::kTest && turn.state.task != StepKind::kTest) return false;
  for (const std::string& item : ItemsOf(*lesson, *step)) {
    if (item == turn.state.item || item == turn.state.mate) return true;
  }
  return false;
}

/// The lesson whose script sets the item: the present one if it asks for it, otherwise its home.
const Lesson* LessonOfItem(const Turn& turn) {
  return IsOfStep(turn) ? LessonNow(turn) : HomeOf(turn.course, turn.state.item);
}

void AskPair(Turn& turn) {
  // Which of the two comes first says nothing: always in order.
  const auto& [first, second] = std::minmax(turn.state.item, turn.state.mate);
  Say(turn, Sentence::kAskPick, first, second);
}

}  // namespace

std::string HintNow(const Turn& turn) {
  if (IsAsked(turn.state.task) || turn.state.item.empty()) return {};
  return HintOf(turn.course, LessonOfItem(turn), turn.state.item);
}

int HelpByRules(const Turn& turn) {
  const LessonState& state = turn.state;
  if (state.overrule.help) return *state.overrule.help;
  if (state.task != StepKind::kTrace && state.task != StepKind::kDemonstrate) {
    return state.overrule.mode ? std::clamp(turn.course.fade.start, 0, kMostHelp) : 0;
  }
  const auto found = state.progress.items.find(state.item);
  const double help =
      found != state.progress.items.end() ? found->second.help : turn.course.fade.start;
  return std::isfinite(help) ? static_cast<int>(std::lround(std::clamp(help, 0.0, 10.0))) : 0;
}

double SizeByRules(const Turn& turn) {
  const LessonState& state = turn.state;
  const Step* step = StepNow(turn);
  if (state.task == StepKind::kExplore || state.task == StepKind::kRead) {
    const bool sized = state.own_text.empty() && step != nullptr && step->size;
    return sized ? *step->size : TextSize(turn, LowerCase(TextNow(turn)));
  }
  return AskedSize(turn.course, state.progress, IsOfStep(turn) ? step : nullptr,
                   {state.item, state.mate});
}

void PresentItem(Turn& turn, const std::string& item, StepKind task, bool review) {
  LessonState& state = turn.state;
  const Step* step = StepNow(turn);
  state.item = item;
  state.mate.clear();
  state.own_text.clear();
  state.task = task;
  state.review = review;
  state.question = IsAsked(task) && !review && step != nullptr ? step->question : Question::kName;
  state.probe = false;
  const ItemProgress progress = ProgressOf(turn, item);
  if (IsAsked(task)) MakePair(turn);
  if (task == StepKind::kTrace) state.probe = HelpByRules(turn) > 0 && IsProbe(turn, progress);
  if (task == StepKind::kDemonstrate && !progress.introduced) {
    Say(turn, Sentence::kNewItem, item);
    const std::string hint = HintNow(turn);
    if (!hint.empty()) Say(turn, Sentence::kHint, hint);
  }
  if (std::exchange(state.another, false) && IsAsked(task)) {
    SayCount(turn, Sentence::kAnother, {}, state.question == Question::kSame ? 2 : 1, 0);
  }
  Ask(turn);
  ShowPage(turn);
}

void PresentText(Turn& turn, const Step& step) {
  LessonState& state = turn.state;
  state.item.clear();
  state.mate.clear();
  state.own_text.clear();
  state.task = step.kind;
  state.question = Question::kName;
  state.review = state.probe = false;
  Ask(turn);
  ShowPage(turn);
}

void PresentOwnText(Turn& turn, const std::string& text) {
  LessonState& state = turn.state;
  state.item.clear();
  state.mate.clear();
  state.own_text = text;
  state.task = StepKind::kRead;
  state.question = Question::kName;
  state.review = state.probe = false;
  Ask(turn);
  const std::string unmet = UnmetSigns(turn.course, state.progress, text);
  if (!unmet.empty()) Say(turn, Sentence::kNotLearnt, unmet);
  ShowPage(turn);
}

void Ask(Turn& turn) {
  const LessonState& state = turn.state;
  switch (state.task) {
    case StepKind::kExplore:
      return Say(turn, Sentence::kExploreIt);
    case StepKind::kRead:
      return Say(turn, Sentence::kReadIt, TextNow(turn));
    case StepKind::kDemonstrate:
      return Say(turn, Sentence::kLedAlong, state.item);
    case StepKind::kTrace:
      SayCount(turn, Sentence::kTraceIt, state.item, state.held ? 1 : 0, 0);
      if (state.probe) Say(turn, Sentence::kProbe);
      return;
    case StepKind::kRecognise:
    case StepKind::kTest:
      break;
  }
  if (state.question == Question::kPick) return AskPair(turn);
  Say(turn, state.question == Question::kSame ? Sentence::kAskSame : Sentence::kAskName);
}

void ShowPage(Turn& turn) {
  LessonState& state = turn.state;
  const bool text = state.task == StepKind::kExplore || state.task == StepKind::kRead;
  const bool own = !state.own_text.empty();  // in the course's script, whatever the lesson's is
  const Lesson* home = own ? nullptr : text ? LessonNow(turn) : LessonOfItem(turn);
  lesson_action::Show show;
  show.text = text ? TextNow(turn) : state.item;
  if (state.question == Question::kSame && IsAsked(state.task)) show.text += " " + state.mate;
  show.script = home != nullptr && !home->script.empty() ? home->script : turn.course.script;
  show.grade = home != nullptr ? home->grade : own ? turn.course.grade : 1;
  show.size = state.overrule.size.value_or(SizeByRules(turn));
  show.one_page = text && !own && StepNow(turn) != nullptr && StepNow(turn)->one_page;
  show.told = !IsAsked(state.task);
  state.size = show.size;
  turn.actions.emplace_back(show);
  Push(turn);
  state.most_help = state.help;
  AwaitNow(turn, AwaitOf(state.task));
}

void ChangePush(Turn& turn) {
  Push(turn);
  turn.state.most_help = std::max(turn.state.most_help, turn.state.help);
  AwaitNow(turn, turn.state.await);
}

}  // namespace moontrace
