#pragma once

#include "lessons/measure/intended_strokes.h"
#include "sim/audio/path_events.h"
#include "sim/audio/sound.h"
#include "sim/learn/running_lesson.h"

namespace moontrace {

/// Lets the tip's path be heard at the rate of polling: pan and pitch by its place on what is
/// traced, a tone that grows off the line, and earcons for begin and end of touch. Silent while
/// something is to be recognised, whose shape would be heard.
class PathListener {
 public:
  /// All must outlive this.
  PathListener(Sound& sound, const LearnStage& stage, LearnTeller& teller,
               const RunningStage& running)
      : sound_(sound), stage_(stage), teller_(teller), running_(running) {}
  /// What happens on the path is also said as a line, except begin and end of touch, which the
  /// path's own tone has.
  void Hear();

 private:
  Sound& sound_;
  const LearnStage& stage_;
  LearnTeller& teller_;
  const RunningStage& running_;
  PathEvents events_;
};

/// Where a tip is within the box of strokes, and how far off: 0 on a centre line, 1 a stroke's
/// width and more beyond its edge.
PathSound SoundOf(const std::vector<IntendedStroke>& strokes, glm::dvec2 tip_P, bool in_contact);

}  // namespace moontrace
