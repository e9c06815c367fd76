#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/audio/earcon.h"
#include "textures/base/toml_reader.h"

namespace moontrace {

/// Families of earcons differ in timbre: what a note is made of.
enum class Timbre : std::uint8_t {
  kPure,   ///< a sine
  kBell,   ///< a sine and two high partials out of tune, dying away
  kReed,   ///< odd harmonics
  kBrass,  ///< all harmonics
};

struct Note {
  double pitch = 440;  ///< [Hz]; 0: a pause
  double length = 0;   ///< [s]
};

/// One earcon: notes of one timbre, or a recording in their place.
struct EarconSound {
  bool on = true;
  Timbre timbre = Timbre::kPure;
  double volume = 1;  ///< 0-1
  std::vector<Note> notes;
  std::vector<float> recording;  ///< mono at `kSoundRate`; not empty: instead of the notes
};

/// How the path of the tip sounds.
struct PathTone {
  bool on = true;
  double low = 200, high = 400;  ///< pitch at y = 0 and y = 1 [Hz]
  double volume = 0.5;           ///< 0-1
  double off_line_pitch = 800;   ///< of the trembling tone off the line [Hz]
  double off_line_volume = 0.5;  ///< of that at its greatest, 0-1; with `volume` at most 1
};

inline constexpr double kSoundRate = 48000;  ///< of all that is synthesised [Hz]

/// All sounds, from `sim/app/sounds.toml` (ours) and a file of the user's that overlays it.
struct SoundTable {
  double volume = 0.5;  ///< of everything, 0-1
  PathTone path;
  std::array<EarconSound, kEarcons> earcons;
};

/// The shipped sounds, changed by what `own` holds: a TOML file with the same keys, each optional.
/// Empty: `$XDG_CONFIG_HOME/moontrace/sounds.toml` if it is there. Throws InputError (place, cause,
/// nearest key), also for recordings that are no WAV, longer than 0.5 s or too large.
SoundTable LoadSounds(const std::string& own = {});

/// Changes `table` by the keys of a document; recordings' paths are from `folder`. For LoadSounds
/// and tests. Throws InputError, and then `table` may be half changed.
void ApplySounds(const TomlTable& document, const std::string& folder, SoundTable& table);

}  // namespace moontrace
