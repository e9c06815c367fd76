#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "sim/reader/reader_knowledge.h"

namespace moontrace {

/// What the hand feels, made out from the readings of a device; as late as those.
struct Felt {
  double time = 0;          ///< now [s]
  glm::dvec3 tip{0, 0, 0};  ///< [m]
  glm::dvec2 place{0, 0};   ///< where the tip is on the paper, the device's give allowed for [m]
  glm::dvec2 wall{0, 0};    ///< sideways force on the tip [N]
  /// Below the flat, as a share of a groove's depth, or above it of a ridge's height; of a hand
  /// that does not feel its height how surely walls hold the tip, 0-1.
  double depth = 0;
  bool touching = false;  ///< the paper carries the press
  bool held = true;       ///< a wall holds the tip just now; true where height is felt
};

/// Keeps the level of flat paper. Without a height it goes by the walls: a tip that one holds is in
/// a groove, and stays in it for a while after, since nothing is felt where it lies at the bottom.
class TouchSense {
 public:
  TouchSense() = default;
  explicit TouchSense(const ReaderKnowledge& knowledge, double tick);

  /// One tick's reading, while the hand means to press or not.
  const Felt& Add(const ReaderInput& input, bool presses) noexcept;
  /// The hand is lifted.
  void Lift() noexcept;

  const Felt& felt() const { return felt_; }
  double resting_for() const { return resting_for_; }  ///< on the paper, neither up nor down [s]
  double level() const { return level_; }  ///< of the tip that presses on flat paper [m]
  /// Of a tip that only just touches flat paper, as far as landings told it [m].
  double surface() const { return level_ + yields_ * press_; }
  bool level_known() const { return level_known_; }

 private:
  void FeelWalls(bool presses) noexcept;
  void FindLevel() noexcept;
  void FindGive(const ReaderInput& input) noexcept;
  void FindGiveInSwing(const ReaderInput& input) noexcept;

  double tick_ = 1e-3;
  double press_ = 1, depth_ = 1, width_ = 1;
  double up_ = 1;      ///< from letters to flat paper: out of the paper, or into it from ridges
  double give_ = 0;    ///< of the device [m/N]
  double yields_ = 0;  ///< device and paper, under a press [m/N]
  bool landed_ = false;
  bool swings_tell_ = false;  ///< how far those yield; else landings do
  int swings_ = 0;            ///< that told
  double last_step_ = 0;      ///< of the tip's height between ticks, the last that was not 0 [m]
  double last_press_ = 0;     ///< of the tip on the paper, a tick ago [N]
  bool feels_height_ = true;
  double hold_ = 1;         ///< ReaderKnowledge::Hold [N]
  double late_ = 0;         ///< how late it feels [s]
  double presses_for_ = 0;  ///< [s]
  glm::dvec2 calm_{0, 0};   ///< the walls' force without trembling [N]
  Felt felt_;
  double level_ = 0;
  bool level_known_ = false, begun_ = false;
  double resting_for_ = 0;       ///< [s]
  double touches_for_ = 0;       ///< [s]
  double mean_height_ = 0;       ///< since it touches, over a while [m]
  bool above_ = false;           ///< the level
  glm::dvec2 above_from_{0, 0};  ///< where it came to be [m]
  double last_height_ = 0;       ///< [m]
  double sink_ = 0;              ///< smoothed vertical speed [m/s]
};

/// How far a hand strays from its aim over flat paper without meaning to, as it finds when it
/// compares where it feels itself to be with where it aimed at that time.
class AimDrift {
 public:
  AimDrift() = default;
  /// `tick` [s].
  AimDrift(const ReaderKnowledge& knowledge, double tick);

  /// A landing: it strays anew.
  void Begin() noexcept;
  /// One tick over the paper with this aim [m].
  void Add(const Felt& felt, glm::dvec2 aim) noexcept;
  glm::dvec2 drift() const { return drift_; }  ///< [m]

 private:
  double tick_ = 1e-3;
  std::vector<glm::dvec2> aims_;  ///< of the time by which it feels late, a ring buffer [m]
  std::size_t count_ = 0;
  glm::dvec2 drift_{0, 0};
};

/// How far a hand strays to the left of where it is heading, without meaning to, as it finds when
/// it compares where it feels itself to be on flat paper with where it aimed at that time.
class AsideDrift {
 public:
  /// `learn`: over how long it compares [s]; `tick` [s].
  AsideDrift(const ReaderKnowledge& knowledge, double learn, double tick);

  /// A landing: where it aimed before says nothing.
  void Begin() noexcept;
  /// One tick with this aim and heading, unit; `flat`: nothing but paper is felt.
  void Add(glm::dvec2 tip, bool flat, glm::dvec2 aim, glm::dvec2 heading) noexcept;
  double left() const { return left_; }  ///< [m]

 private:
  struct Then {
    glm::dvec2 aim{0, 0}, heading{1, 0};
  };
  double share_ = 0;        ///< of what is new in a tick
  std::vector<Then> then_;  ///< of the time by which it feels late, a ring buffer
  std::size_t count_ = 0;
  double left_ = 0;
};

}  // namespace moontrace
