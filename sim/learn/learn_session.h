#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lessons/course/course.h"
#include "lessons/machine/lesson_machine.h"
#include "sim/learn/learn_memory.h"
#include "sim/learn/learn_stage.h"
#include "sim/learn/learn_teller.h"
#include "sim/learn/learn_words.h"

namespace moontrace {

/// A lesson in progress: the machine's actions become pages, pushes, sentences and rows; words,
/// what the hand did and the clock become its events. All in one thread.
class LearnSession {
 public:
  /// All must outlive this. `help`: the lines that ? gives.
  LearnSession(const Course& course, LearnMemory& memory, LearnStage& stage, LearnTeller& teller,
               std::uint64_t seed, std::vector<std::string> help);

  /// The learner sits down.
  void Begin();
  /// A line that was typed; always answered by a line.
  void Obey(const std::string& line);
  /// Takes what has happened since the last call: at the rate of polling.
  void Look();
  /// Behind it all: what is held back is kept, and the outcome reported. Number of rows not kept.
  std::size_t End();
  bool over() const { return over_; }
  /// What is asked now.
  Asked asked() const;
  /// What is waited for: the answer to an empty line.
  std::string Awaited() const;

  // For the tutor. The caller tells the learner first.
  void TutorSays(lesson_event::Said said) { Take(said); }
  void Overrule(const lesson_event::Overrule& overrule) { Take(overrule); }
  /// The force rests; a pause by the tutor ends by the tutor's word or the learner's.
  void Pause(bool by_tutor);
  /// False: nothing rests, or the learner's own stop stands.
  bool GoOn(bool by_tutor);
  /// As Pause, and all sound and speech end.
  void Stop(bool by_tutor);
  bool stopped() const { return stopped_; }
  /// Leads the hand along a path once; nothing of it counts, then the trace begins anew.
  void Lead(std::shared_ptr<const GuidancePath> path);
  /// Lesson, step, item, size, help, what the tip feels: one line.
  std::string Status() const;
  const LessonState& state() const { return state_; }
  LearnStage& stage() { return stage_; }
  const LearnStage& stage() const { return stage_; }
  const Course& course() const { return course_; }
  LearnMemory& memory() { return memory_; }
  const LearnMemory& memory() const { return memory_; }
  LearnTeller& teller() { return teller_; }
  const LoopSnapshot& newest() const { return newest_; }

 private:
  using Clock = std::chrono::steady_clock;

  void Take(decltype(Event::what) what);
  void Do(const lesson_action::Say& sentence);
  void Do(const lesson_action::Show& show);
  void Do(const lesson_action::Push& push);
  void Do(const lesson_action::Keep& keep);
  void Do(lesson_action::Await await);
  void Answer(const std::string& text);
  void Speak(LearnWord word);
  void Next();
  void EndTrace();
  void Where();
  void Letter(LearnWord word);
  void LookAtEvents();
  void LookAtStop();
  void LookAtTrace();
  void SayPath();
  Trial Flags(Trial measured) const;
  bool told() const { return stage_.shown().told || stage_.simulated(); }
  std::int64_t Now() const;

  const Course& course_;
  LearnMemory& memory_;
  LearnStage& stage_;
  LearnTeller& teller_;
  std::vector<std::string> help_;
  LessonState state_;
  lesson_action::Await await_ = lesson_action::Await::kNext;
  LoopSnapshot newest_;
  bool leading_ = false;  ///< the hand is led along, or would be
  bool lent_ = false;     ///< led by the tutor meanwhile
  bool shown_ = false;    ///< in this turn
  bool stopped_ = false, stopped_by_tutor_ = false;
  bool paused_ = false;  ///< stopped by "pause", not by "stop"
  bool silent_ = false;
  bool over_ = false;
  double felt_ = 0;  ///< time that the page could be felt [s]
  Clock::time_point looked_, ordered_, ticked_;
  std::string why_lost_;
  std::size_t kept_ = 0;
};

}  // namespace moontrace
