#pragma once

namespace moontrace {

/// Where the tip is on what it follows, to be heard: pan is x, pitch is y, and a trembling tone
/// grows with the distance from the stroke.
struct PathSound {
  bool in_contact = false;  ///< false: silence
  double x = 0, y = 0;      ///< in the box of the letter or page, 0-1; held to that
  double off_line = 0;      ///< 0: on the stroke; 1: as far as the tone grows; held to that
};

}  // namespace moontrace
