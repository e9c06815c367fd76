#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <limits>
#include <optional>

#include "sim/audio/earcon.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// What a tip has come past on a page of several letters.
enum class PassedEnd { kNothing, kLine, kPage };

/// Whether a tip stands behind the last letter of the line that it is on, more than a quarter em
/// beyond it; the last line's end is the page's. `tip_P` [m].
PassedEnd PassedEndOf(const TextPage& page, const Script& script, const TypeStyle& style,
                      glm::dvec2 tip_P);

/// One moment of a tip on its path.
struct PathMoment {
  double time = 0;  ///< [s]
  bool touching = false;
  double off_line = 0;  ///< see PathSound
  PassedEnd end = PassedEnd::kNothing;
};

/// Finds what on a path is worth a sound and a line of text: begin and end of touch, off the line
/// and on it again, end of a line and of a page. Each of the last four at most once in 3 s, so that
/// its line can be read.
class PathEvents {
 public:
  PathEvents() { last_.fill(-std::numeric_limits<double>::infinity()); }

  /// Moments in order of time; what has happened since the one before.
  std::optional<Earcon> Take(const PathMoment& now);

 private:
  std::optional<Earcon> Changed(const PathMoment& now);

  bool touching_ = false, off_ = false;
  PassedEnd end_ = PassedEnd::kNothing;
  std::array<double, kEarcons> last_;  ///< when each last happened [s]
};

}  // namespace moontrace
