#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lessons/course/course.h"
#include "lessons/progress/lesson_machine.h"
#include "sim/console/vocabulary.h"
#include "sim/learn/learn_memory.h"
#include "sim/learn/learn_messages.h"
#include "sim/learn/learn_stage.h"
#include "sim/learn/learn_teller.h"
#include "sim/learn/learn_words.h"
#include "sim/learn/lesson_voice.h"
#include "sim/learn/running_lesson.h"
#include "sim/session/loop_poll.h"
#include "sim/session/place_walk.h"

namespace moontrace {

/// A lesson in progress: the machine's actions become pages, pushes, sentences and rows; words,
/// what the hand did and the clock become its events. All in one thread.
class LearnSession : public RunningLesson, private LoopListener {
 public:
  LearnSession(const LearnParts& parts, std::uint64_t seed, say::HelpLines help);

  /// The learner sits down.
  void Begin();
  /// Takes what has happened since the last call: at the rate of polling.
  void Look();
  /// Behind it all: what is held back is kept, and the outcome reported. Number of rows not kept.
  std::size_t End();
  /// What is asked now.
  Asked asked() const;
  /// What is waited for: the answer to an empty line.
  std::string Awaited() const;

  const LessonState& state() const override { return state_; }
  const LoopPoll& poll() const override { return poll_; }
  bool stopped() const override { return stopped_; }
  bool waits() const override { return away_; }
  bool over() const override { return over_; }
  std::string Status() const override;
  std::vector<std::string> StatusForTutor() const override;
  void Obey(const std::string& typed) override;
  void TutorSays(lesson_event::Said said) override { Take(said); }
  void Overrule(const lesson_event::Overrule& overrule) override { Take(overrule); }
  void Pause(bool by_tutor) override;
  bool GoOn(bool by_tutor) override;
  void Stop(bool by_tutor) override;
  void Lead(std::shared_ptr<const GuidancePath> path) override;

 private:
  using Clock = std::chrono::steady_clock;

  void Take(decltype(Event::what) what);
  void Do(const lesson_action::Say& sentence);
  void Tell(const lesson_action::Say& sentence);
  void TellSize(const lesson_action::Show& show);
  void Do(const lesson_action::Show& show);
  void Do(const lesson_action::Push& push);
  void Do(const lesson_action::Keep& keep);
  void Do(lesson_action::Await await);
  void Answer(const std::string& text);
  void GoToLesson(const std::string& given);
  void TellLessons();
  void TellHowItGoes();
  bool OnlyNamed(const std::string& text) const;
  void TellOthers(const std::vector<std::string>& asked);
  void Help();
  void Brief(bool brief);
  void OwnText(const std::string& given);
  void GoToPlace(const PlaceCommand& command);
  void LookAtPlace();
  void Speak(LearnWord word);
  void Rest();
  void Next();
  bool JudgedAtNext() const;
  void Back();
  void EndTrace();
  void Where();
  void Letter(LearnWord word);
  void Happened(const LoopEvent& event, const std::string& sentence) override;
  void Reported(const std::string& sentence, bool urgent) override;
  void Stands(const LoopSnapshot& newest) override;
  void Felt(const LoopSample& sample) override;
  bool AsksNumbers() const;
  void LookAtStop();
  void LookAtDevice(const LoopSnapshot& newest);
  void GoAway(const std::string& sentence);
  void ComeBack();
  bool WaitsWith(const LearnLine& read) const;
  void LookAtTrace();
  void SayPath();
  void SayAskedPath();
  bool GoesOnUnsaid(const lesson_action::Say& sentence);
  Trial Flags(Trial measured) const;
  bool told() const { return stage_.shown().told; }
  std::int64_t Now() const;

  const Course& course_;
  LearnMemory& memory_;
  LearnStage& stage_;
  LearnTeller& teller_;
  say::HelpLines help_;
  LessonState state_;
  lesson_action::Await await_ = lesson_action::Await::kNext;
  LoopPoll poll_;
  PlaceWalk walk_;
  LessonVoice voice_;
  Proposal proposal_;
  bool leading_ = false;       ///< the hand is led along, or would be
  bool led_by_tutor_ = false;  ///< the tutor leads the hand meanwhile
  bool shown_ = false;         ///< in this turn
  bool in_full_ = false;       ///< asked for in this turn: said in full, brief or not
  bool helped_ = false;        ///< the last line was ?
  bool asks_text_ = false;     ///< the next line is a text of the learner's own
  bool asks_sign_ = false;     ///< the next line is a sign to practise, if it names one
  bool stopped_ = false, stopped_by_tutor_ = false;
  bool paused_ = false;  ///< stopped by "pause", not by "stop"
  bool over_ = false;
  bool away_ = false;       ///< the device is lost: nothing is asked, led or counted
  bool back_ = false;       ///< it was told that it is there again
  bool mend_told_ = false;  ///< once a session
  double there_ = 0;        ///< while away: how long it has been there again [s]
  double felt_ = 0;         ///< time that the page could be felt [s]
  double passed_ = 0;       ///< between the last two looks [s]
  Clock::time_point looked_, ordered_, ticked_;
  std::size_t kept_ = 0;
  double no_room_ = 0;  ///< it was told that letters of that size have no room [m]
  std::optional<lesson_action::Say> sized_;  ///< told once the page lies there
  std::string missed_;                       ///< the sign of the last trace, if that was not good
  std::map<std::string, int> rounds_;        ///< of the program's hand around each sign, in a row
  bool unsaid_ = false;                      ///< what it traces now is told no more
  Trial last_right_, last_wrong_;            ///< of this session; without an item: none yet
};

}  // namespace moontrace
