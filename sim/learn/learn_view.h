#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/learn/learn_tutor.h"
#include "sim/learn/running_lesson.h"
#include "sim/session/view_feed.h"

namespace moontrace {

/// A lesson in a window, beside it the tutor's panel. What is typed there is the learner's, unless
/// only tutors have such a word.
class LearnView {
 public:
  /// All must outlive this.
  LearnView(ViewFeed& feed, const LearnParts& parts, RunningLesson& lesson, TutorDesk& desk,
            Console& console);
  ~LearnView();
  LearnView(const LearnView&) = delete;
  LearnView& operator=(const LearnView&) = delete;

  /// Shows what there is and does what was said, at the rate of polling.
  void Look();
  /// The learner has ended the lesson in the window: nobody need be at the terminal.
  bool left() const { return left_; }

 private:
  void Obey(const ViewLine& line);
  void Help();
  void Answer(std::string_view line);

  ViewFeed& feed_;
  LearnParts parts_;
  RunningLesson& lesson_;
  TutorDesk& desk_;
  Console& console_;
  bool left_ = false;
};

/// The panel of a lesson, and what it shows.
std::vector<PanelControl> LearnPanel();
std::vector<PanelValue> LearnPanelValues(const LearnParts& parts, const RunningLesson& lesson);

}  // namespace moontrace
