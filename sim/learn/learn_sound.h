#pragma once

#include "sim/audio/path_events.h"
#include "sim/audio/sound.h"
#include "sim/learn/learn_session.h"

namespace moontrace {

/// Lets the tip's path be heard at the rate of polling: pan and pitch by its place on what is
/// traced, a tone that grows off the line, and earcons for begin and end of touch. Silent while
/// something is to be recognised, whose shape would be heard.
class PathListener {
 public:
  explicit PathListener(Sound& sound) : sound_(sound) {}
  /// What happens on the path is also said as a line, except begin and end of touch, which the
  /// path's own tone has.
  void Hear(LearnSession& session);

 private:
  Sound& sound_;
  PathEvents events_;
};

/// Where a tip is within the box of strokes, and how far off: 0 on a centre line, 1 a stroke's
/// width and more beyond its edge.
PathSound SoundOf(const std::vector<IntendedStroke>& strokes, glm::dvec2 tip_P, bool in_contact);

}  // namespace moontrace
