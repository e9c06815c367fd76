#pragma once

#include <vector>

#include "sim/audio/sound_table.h"

namespace moontrace {

/// Where the tip is on what it follows, to be heard: pan is x, pitch is y, and a trembling tone
/// grows with the distance from the stroke.
struct PathSound {
  bool in_contact = false;  ///< false: silence
  double x = 0, y = 0;      ///< in the box of the letter or page, 0-1; held to that
  double off_line = 0;      ///< 0: on the stroke; 1: as far as the tone grows; held to that
};

/// One earcon, mono at kSoundRate, within -1 to 1, without a step at any end: every note swells for
/// 5 ms and dies for 8 ms. No partial is above 5 kHz. A recording fades at its ends as notes do.
std::vector<float> RenderEarcon(const EarconSound& sound);

/// The tone of the path. A value type: copies sound alike.
class PathVoice {
 public:
  struct Frame {
    float left = 0, right = 0;
  };

  explicit PathVoice(const PathTone& tone) : tone_(tone) {}
  /// The next of kSoundRate frames a second; pitch, pan and loudness glide to `target` with a time
  /// constant of 8 ms. Pan keeps the power: left cos, right sin of a quarter turn. Within -1 to 1.
  Frame Next(const PathSound& target) noexcept;

 private:
  PathTone tone_;
  double x_ = 0.5, y_ = 0.5;                        ///< glided
  double loud_ = 0, off_ = 0;                       ///< 0-1, glided
  double phase_ = 0, off_phase_ = 0, tremble_ = 0;  ///< [turns]
};

}  // namespace moontrace
