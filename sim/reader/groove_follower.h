#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "sim/reader/reader_knowledge.h"
#include "sim/reader/sign_belief.h"
#include "sim/reader/touch_sense.h"

namespace moontrace {

/// Follows a groove from where the tip lies in it: the aim goes ahead at an even speed in the
/// direction of the tip's own motion and yields to the walls' force, so that they steer. Where the
/// tip stops, the pull is swung to 100
/// degrees on either side: motion there is a corner, none an end. (So far no turn of 100 degrees
/// leads back along the groove one came by, and it takes corners of some 140; for sharper ones,
/// where they are expected, it is swung to 140.)
class GrooveFollower {
 public:
  enum class State { kMoving, kStopped, kSwinging, kEnded, kRing, kLost };

  GrooveFollower() = default;
  explicit GrooveFollower(const ReaderKnowledge& knowledge);

  /// Begins anew at the tip, from where the hand aims, in a direction [unit] that is tried first.
  /// What comes before `feels_from` [s] was felt elsewhere.
  void Begin(const Felt& felt, glm::dvec2 aim, glm::dvec2 direction, double feels_from);
  /// One tick. Gives the aim in the paper's plane [m].
  glm::dvec2 Step(const Felt& felt);

  State state() const { return state_; }
  bool done() const { return state_ >= State::kEnded; }
  /// At a stop (kStopped): swings to these sides. To none: only glances to both, as at an end.
  /// `sharp`: for a corner that turns farther than the swing, into which the tip slides slowly.
  void Try(bool left, bool right, bool sharp = false);
  glm::dvec2 stop() const { return stop_; }            ///< where it stopped last [m]
  glm::dvec2 direction() const { return direction_; }  ///< of the pull before it stopped, unit
  /// Where the tip went within the groove, evenly spaced [m].
  const std::vector<glm::dvec2>& path() const { return path_; }
  /// Points beyond walls that it could not pass.
  const std::vector<FeltPoint>& blocked() const { return blocked_; }
  /// In which it left the place where it began, unit; where it never did, the direction that was
  /// tried.
  glm::dvec2 Departure() const;

 private:
  void Move(const Felt& felt);
  void Swing(const Felt& felt);
  void Steer(double dt);
  void GoBack(const Felt& felt);
  void StartSwing(const Felt& felt);
  void AddPoint(glm::dvec2 p);
  bool IsGoingBack(glm::dvec2 p) const;
  bool HasClosed() const;
  glm::dvec2 Foreseen() const;
  void Turn(glm::dvec2 direction, double time);
  double AngleAt(double t) const;
  glm::dvec2 SwungAim(double time) const;
  double SwingTime() const;
  double SideTime() const;
  double SwingAngle() const;
  void NoteBlocked();
  void Stop(const Felt& felt);

  double width_ = 0, hold_ = 0, stiffness_ = 1, late_ = 0, wait_ = 0, speed_ = 0, gentle_ = 0,
         longest_ = 0;
  double closed_ = 0, still_ = 0, moved_ = 0;  ///< [m]
  State state_ = State::kLost;
  glm::dvec2 direction_{1, 0};
  bool has_moved_ = false;
  double side_ = 1;        ///< first tried at a stop: 1 left, -1 right
  glm::dvec2 aim_{0, 0};   ///< [m]
  glm::dvec2 wall_{0, 0};  ///< force of the walls, without the hand's trembling [N]
  double since_ = 0;       ///< the pull has this direction [s]
  double lost_for_ = 0, last_time_ = 0;
  double feels_from_ = 0;  ///< [s]
  double mark_time_ = 0, back_since_ = 0;
  glm::dvec2 mark_{0, 0};  ///< where the tip was at `mark_time_`
  glm::dvec2 stop_{0, 0}, anchor_{0, 0}, from_{0, 0};
  double angle_ = 0;                 ///< of the swing [rad]
  bool left_ = true, right_ = true;  ///< sides that are tried
  bool glances_ = false;
  bool sharp_ = false;  ///< a corner that turns farther than the swing is tried
  int swings_ = 0;
  double ahead_ = 0;      ///< speed of the aim [m/s]
  std::size_t sure_ = 1;  ///< of the path's points: when a wall held the tip last
  std::size_t leg_ = 0;   ///< of the path's points: where the last corner was
  double length_ = 0;     ///< of the path [m]
  std::vector<glm::dvec2> path_;
  std::vector<FeltPoint> blocked_;
};

}  // namespace moontrace
