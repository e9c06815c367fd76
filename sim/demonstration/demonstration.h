#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sim/console/vocabulary.h"
#include "sim/learn/learn_stage.h"
#include "sim/learn/learn_teller.h"
#include "sim/learn/running_lesson.h"
#include "sim/session/loop_poll.h"

namespace moontrace {

/// A part of the demonstration: a page, what is said of it line by line, then perhaps a question.
struct DemonstrationStep {
  std::string show;                  ///< text on the page; empty: the former one stays
  double size = 0.025;               ///< of its letters [m]
  std::vector<std::string> say;      ///< lines, in order
  std::string ask;                   ///< empty: nothing is asked
  std::vector<std::string> answers;  ///< right ones, in small letters
  std::string right, wrong;          ///< said to a right answer; to none, and after a wrong one
  std::vector<std::string> ways;     ///< words, from its begin on: how it may go on behind all this
};

/// The demonstration that comes with the program, `lessons/demonstration.toml`. Throws InputError:
/// file:line:column, cause, cure.
std::vector<DemonstrationStep> ShippedDemonstration();
/// The same from TOML; `name` stands in messages.
std::vector<DemonstrationStep> ParseDemonstration(std::string_view toml, const std::string& name);

/// Goes through a demonstration by itself: a line at a time, as fast as it can be heard, with
/// questions that are awaited half a minute. One thread.
class Demonstration final : public RunningStage, private LoopListener {
 public:
  using Clock = std::chrono::steady_clock;

  /// All must outlive this. `help`: the lines that ? gives.
  Demonstration(const std::vector<DemonstrationStep>& steps, LearnStage& stage, LearnTeller& teller,
                std::vector<std::string> help);

  /// Says and shows what its time has come for. At the rate of polling, with the time.
  void Look(Clock::time_point now);
  /// A line that was typed; always answered by a line or by what comes next.
  void Obey(const std::string& line);
  /// Nobody will answer any more: nothing is waited for from now on.
  void Hurry() {
    hurries_ = true;
    paused_ = false;
  }
  /// Who was at the terminal has left it: it ends, and says so.
  void Leave();
  /// An answer is awaited, or the choice of a way on.
  bool asks() const { return asking_ || (begun_ && !over_ && !step().ways.empty()); }
  /// Of the ways of a step, which was chosen: it is over by that; empty: none.
  const std::string& way() const { return way_; }
  /// What lies there is asked, or will be before another page does: nothing must show it in print.
  bool hides() const;
  bool over() const { return over_; }

  const LoopPoll& poll() const override { return poll_; }
  bool stopped() const override { return paused_; }

 private:
  const DemonstrationStep& step() const { return steps_[at_]; }
  void GoOn();
  void NextStep();
  void Say(const std::string& line);
  void Reply(const std::string& line);
  void Answer(const std::string& given);
  bool AsksWord() const;
  bool IsAnswer(const std::string& given) const;
  bool Takes(const std::string& given);
  void GoOnAgain();
  bool CameLate(const std::string& given) const;
  void TellLate();
  void StillAsk();
  void AskAgain();
  bool TakesWay(const std::string& given);
  /// All ways on were told, and one of them may be chosen.
  bool Chooses() const { return asked_ && !step().ways.empty(); }
  void TellWays();
  void Do(std::string_view word);
  void WaitFor(double seconds);

  void Happened(const LoopEvent&, const std::string&) override {}  // nothing is felt here
  void Reported(const std::string&, bool) override {}
  void Stands(const LoopSnapshot&) override {}
  void Felt(const LoopSample& sample) override { stage_.Add(sample, true); }

  const std::vector<DemonstrationStep>& steps_;
  LearnStage& stage_;
  LearnTeller& teller_;
  std::vector<std::string> help_;
  LoopPoll poll_;
  std::size_t at_ = 0, line_ = 0;  ///< step, and the line of it that comes next
  std::string last_;               ///< said last
  std::string way_;
  Proposal proposal_;
  /// What was asked last and not answered in its time; null: none, or something was answered since.
  const DemonstrationStep* missed_ = nullptr;
  std::string told_;  ///< signs that were shown so far
  Clock::time_point now_, until_;
  Clock::time_point heard_;  ///< what is asked has been heard by then
  Clock::duration left_{0};  ///< of the wait, while it is paused
  double pace_ = 1;          ///< factor on what is waited for
  bool begun_ = false, asking_ = false, asked_ = false;
  bool paused_ = false, hurries_ = false, over_ = false;
};

}  // namespace moontrace
