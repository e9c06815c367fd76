#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "lessons/course/trial.h"
#include "lessons/measure/recogniser.h"
#include "sim/study/aim_error.h"
#include "sim/study/felt_hand.h"
#include "sim/study/item_page.h"
#include "sim/study/learner_model.h"
#include "sim/study/two_rate_memory.h"

namespace moontrace {

/// What came of a trace.
struct TracedItem {
  Trial measured;  ///< what TrialMeter fills in
  /// How much of a beginner's whole error of aim the tip was found to have, from below 0 to above
  /// 1: this teaches the hand.
  double felt_error = 0;
};

/// A learner of the program's own: a hand at the real scene, a motor memory for its aim and a
/// recogniser for what it feels. Its aim lies beside the strokes by an error of its own, which
/// becomes less by what it feels while it traces: under a push that corrects the tip it feels
/// little and learns little, under one that amplifies much. Same model, hand, seed and calls: same
/// bytes.
class SimulatedLearner {
 public:
  SimulatedLearner(const LearnerModel& model, const HandModel& hand, std::uint64_t seed,
                   const DeviceProfile* device = nullptr);

  /// Follows the strokes of a named item once. `push`: none, or its plan. Nothing is learnt about
  /// the aim on blank paper, where no error can be felt.
  TracedItem Trace(const std::string& item, const ItemPage& page, const GuidancePlan* push);
  /// Learns again what an earlier trial taught, from the error felt in it, without simulating it.
  void Relive(const std::string& item, double felt_error);
  /// Explores a page by touch alone, late and by what its device reports, from its line's corner to
  /// where nothing more comes, and returns what it felt.
  FeltShape Feel(const ItemPage& page);
  /// Time passes without practice.
  void Wait(double days);

  /// What it remembers of signs: one memory, whatever script a page is in, which nobody tells it.
  Recogniser& shapes() { return shapes_; }
  double day() const { return day_; }  ///< since the learner began
  /// Drawn anew each time: for guesses.
  std::uint64_t Guess() { return SeedOf(seed_, "guess" + std::to_string(++guesses_)); }
  /// Present error of the aim at an item as a share of a beginner's, without the variation from
  /// trial to trial.
  double AimErrorShare(const std::string& item, bool guided) const;
  double seconds() const { return hand_.seconds() + explored_; }  ///< of simulated work [s]
  const LearnerModel& model() const { return model_; }

 private:
  struct Aim;
  void Learn(const std::string& item, double felt_error);
  const TwoRateMemory* Find(const std::string& item) const;

  LearnerModel model_;
  FeltHand hand_;         ///< that traces
  double explored_ = 0;   ///< by touch alone, by another hand of its kind [s]
  double stiffness_ = 1;  ///< of the hand [N/m]
  Recogniser shapes_;
  std::uint64_t seed_ = 1, works_ = 0, guesses_ = 0;
  TwoRateMemory general_;
  std::map<std::string, TwoRateMemory> by_item_;
  double day_ = 0;
};

}  // namespace moontrace
