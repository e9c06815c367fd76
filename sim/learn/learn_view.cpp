#include "sim/learn/learn_view.h"

#include <algorithm>

#include "sim/console/vocabulary.h"
#include "sim/learn/learn_memory.h"
#include "sim/learn/learn_stage.h"
#include "sim/learn/learn_teller.h"
#include "sim/learn/learn_tutor_messages.h"
#include "sim/session/view_controls.h"
#include "sim/session/view_messages.h"
#include "sim/session/view_panels.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

std::vector<std::string> Modes() {
  std::vector<std::string> modes;
  modes.reserve(kGuidanceModeCount);
  for (std::size_t i = 0; i < kGuidanceModeCount; ++i) {
    modes.emplace_back(NameOf(static_cast<GuidanceMode>(i)));
  }
  return modes;
}

std::string TitleOf(const Course& course, const std::string& id) {
  for (const Lesson& lesson : course.lessons) {
    if (lesson.id == id) return lesson.title;
  }
  return {};
}

/// Whether a typed line is a tutor's: its first word is nobody else's, or it says how strong the
/// push is. What both have is the learner's; the tutor has the panel.
bool IsTutorsLine(const std::string& line) {
  constexpr std::string_view kHelp = "help ";
  const std::string said = LowerCase(line);
  if (said == "next lesson") return true;
  if (said.compare(0, kHelp.size(), kHelp) == 0) {
    return said.find_first_of("0123456789") == kHelp.size();
  }
  const TypedWord* word = WordNamed(std::string_view(said).substr(0, said.find(' ')));
  return word != nullptr && word->HoldsIn(WordPlace::kTutor) && !word->HoldsIn(WordPlace::kLesson);
}

}  // namespace

LearnView::LearnView(ViewFeed& feed, const LearnParts& parts, RunningLesson& lesson,
                     TutorDesk& desk, Console& console)
    : feed_(feed), parts_(parts), lesson_(lesson), desk_(desk), console_(console) {
  feed_.SetPanel(LearnPanel());
  parts_.stage.SetWatch([this](const LoopSample& sample) { feed_.Add(sample); });
}

LearnView::~LearnView() { parts_.stage.SetWatch(nullptr); }

void LearnView::Look() {
  feed_.Look(parts_.stage.session().felt(), lesson_.poll(), parts_.stage.shown().told);
  feed_.SetValues(LearnPanelValues(parts_, lesson_));
  const auto obey = [this](const ViewLine& line) {
    if (!lesson_.over()) Obey(line);
  };
  feed_.Hear(obey, [this](const std::string& notice) { parts_.teller.Remark(notice); });
  if (lesson_.over()) return;
  // nothing could move the tip again
  if (feed_.failed() && parts_.stage.session().device().mouse()) return lesson_.Obey("quit");
  if (!feed_.closed()) return;
  parts_.teller.Happening(Priority::kText, say::WindowClosed());
  lesson_.Obey("quit");
}

void LearnView::Obey(const ViewLine& line) {
  if (const std::optional<std::string> done = feed_.Obey(line.text)) return Answer(*done);
  if (line.of_panel || IsTutorsLine(line.text)) {
    return desk_.Hear(line.text, [this](std::string_view answer) { Answer(answer); });
  }
  lesson_.Obey(line.text);
  left_ = lesson_.over();
  if (line.text == "?") Help();
}

/// Behind the learner's words: what else can be typed in the window.
void LearnView::Help() {
  for (const std::string& sentence :
       {say::TutorsInWindow(), say::ViewWordsHelp(), say::ViewColoursHelp()}) {
    Answer(sentence);
  }
}

void LearnView::Answer(std::string_view line) {
  console_.Result(line);
  console_.out().flush();
  feed_.ShowLine(line);
}

std::vector<PanelControl> LearnPanel() {
  std::vector<PanelControl> panel = {HeadingControl("Lesson"), TextControl("Learner"),
                                     TextControl("Lesson"), TextControl("Sign"),
                                     TextControl("The tip")};
  Append(panel, {HeadingControl("Help"), SliderControl("Help", "help", "", 0, 10, 1),
                 ChoiceControl("Mode", "mode", Modes())});
  Append(panel, {HeadingControl("Do"), ButtonControl("Stop", "stop"),
                 ButtonControl("Pause", "pause"), ButtonControl("Go on", "go"),
                 ButtonControl("Again", "again"), ButtonControl("Next", "skip"),
                 ButtonControl("Next lesson", "next lesson"), ButtonControl("Show me", "show")});
  panel.push_back(HeadingControl("Page"));
  Append(panel, PageControls());
  return panel;
}

std::vector<PanelValue> LearnPanelValues(const LearnParts& parts, const RunningLesson& lesson) {
  const LessonState& state = lesson.state();
  const LearnStage& stage = parts.stage;
  const bool told = stage.shown().told || stage.simulated();
  const LoopSnapshot& newest = lesson.poll().newest();
  std::vector<PanelValue> values = {{},
                                    TextValue(parts.memory.name()),
                                    TextValue(TitleOf(parts.course, state.progress.lesson)),
                                    TextValue(told ? state.item : "asked now"),
                                    TextValue(say::PanelState(lesson.stopped(), newest.depth > 0)),
                                    {},
                                    NumberValue(state.help),
                                    ChosenValue(static_cast<int>(state.mode)),
                                    {}};
  values.resize(values.size() + 8);
  const LoopSession& loop = stage.session();
  Append(values, PageValues(loop.text(), stage.form(), loop.tilt()));
  return values;
}

}  // namespace moontrace
