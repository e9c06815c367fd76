#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "sim/audio/sound_synthesis.h"
#include "sim/audio/sound_table.h"
#include "tests/source_path.h"
#include "textures/base/units.h"

namespace moontrace {

inline std::vector<float> Render(const SoundTable& table, Earcon earcon) {
  return RenderEarcon(table.earcons[static_cast<std::size_t>(earcon)]);
}

inline SoundTable Shipped() { return LoadSounds(SourcePath("sim/app/sounds.toml")); }

/// Amplitude at one pitch of a part of a sound, through a Hann window.
inline double AmplitudeAt(const std::vector<float>& sound, std::size_t from, std::size_t count,
                          double pitch) {
  std::complex<double> sum = 0;
  const double step = kTurn * pitch / kSoundRate;
  std::complex<double> turn = 1;
  const std::complex<double> by(std::cos(step), std::sin(step));
  for (std::size_t i = 0; i < count; ++i) {
    const double window =
        0.5 - 0.5 * std::cos(kTurn * static_cast<double>(i) / static_cast<double>(count));
    sum += window * static_cast<double>(sound[from + i]) * turn;
    turn *= by;
  }
  return 4 * std::abs(sum) / static_cast<double>(count);
}

}  // namespace moontrace
