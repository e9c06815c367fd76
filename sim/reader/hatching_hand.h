#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "sim/reader/reader_knowledge.h"
#include "sim/reader/touch_sense.h"

namespace moontrace {

/// A hand that goes over the paper along ways of straight lines: lifts, flies to where a way
/// begins, lands, goes along it evenly, and makes up for how it strays. What it feels on its way is
/// its mind's business.
class HatchingHand {
 public:
  /// `speed` over the paper [m/s]; `learn`: AsideDrift's [s]; `tick` [s].
  HatchingHand(const ReaderKnowledge& knowledge, double speed, double learn, double tick);

  /// The next tick's reading; the first is of a hand that was put over the paper. Before Move.
  void Add(const ReaderInput& input);
  /// What is felt just now, and while it goes along its way the same without the steps of a device
  /// and what they shake loose.
  const Felt& felt() const { return sense_.felt(); }
  const Felt& calm() const { return calm_; }
  bool level_known() const { return sense_.level_known(); }
  double level() const { return sense_.level(); }  ///< of the tip that presses on flat paper [m]

  /// Lifts from the next Move on, and goes along a way from its first point. All [m].
  void Go(std::vector<glm::dvec2> way);
  /// So the way goes on.
  void GoOnTo(glm::dvec2 point) { way_.push_back(point); }
  bool sweeps() const { return state_ == State::kSweeps; }  ///< it is on the paper, on its way
  /// It stands at the way's end, and has felt all that lies there.
  bool ended() const { return ended_; }

  /// What the hand is to do next. `more` is called where the way ends, and may let it go on.
  ReaderAction Move(const std::function<void()>& more);
  ReaderAction Lifted() const;

 private:
  enum class State { kFlies, kSweeps };
  void Calm(double dt);
  ReaderAction Fly();
  void Walk(double length, const std::function<void()>& more);

  double speed_ = 0;   ///< [m/s]
  double flight_ = 0;  ///< one period of the hand's spring [s]
  double late_ = 0;    ///< from what it wants to what it feels [s]
  double press_ = 0;   ///< [N]
  TouchSense sense_;
  AsideDrift drift_;
  Felt calm_;
  State state_ = State::kFlies;
  ReaderAction action_;
  bool begun_ = false;
  double now_ = 0, since_ = 0;  ///< since: the flight's begin, the tick before [s]
  double put_ = 0;              ///< how high, at first [m]
  glm::dvec2 fly_from_{0, 0};
  std::vector<glm::dvec2> way_;
  std::size_t next_ = 0;
  glm::dvec2 aim_{0, 0};
  glm::dvec2 heading_{1, 0};  ///< of the aim, unit
  double waited_ = 0;         ///< at the end of a way [s]
  bool ended_ = false;
};

}  // namespace moontrace
