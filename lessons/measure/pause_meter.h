#pragma once

#include <glm/vec2.hpp>

namespace moontrace {

/// Finds pauses from samples one by one: the tip's mean speed over more than 0.3 s stays below
/// v0 = 2 mm/s (ours). Told by how far it gets, 0.6 mm, not by speeds from tick to tick: a hand
/// trembles faster than it creeps.
class PauseMeter {
 public:
  static constexpr double kLeast = 0.3;    ///< [s]
  static constexpr double kSpeed = 0.002;  ///< v0 [m/s]

  struct Step {
    bool began = false;  ///< another pause was found
    double time = 0;     ///< that the sample adds to pauses [s]
  };
  /// In time order; `p` finite [m].
  Step Add(double time, glm::dvec2 p);
  /// The hand is elsewhere: what comes next is not the same pause.
  void Break() { any_ = false; }

 private:
  bool any_ = false;
  glm::dvec2 rest_{0, 0};  ///< where it has been near since `since_` [m]
  double since_ = 0;       ///< [s]
  double last_ = 0;        ///< [s]
  bool pausing_ = false;
  bool went_on_ = false;  ///< the rest before this one was a pause too
};

}  // namespace moontrace
