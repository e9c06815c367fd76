#pragma once

#include <string>
#include <string_view>

#include "sim/audio/earcon.h"

/// Sentences of sound.
namespace moontrace::say {

namespace help {
inline constexpr const char* kSounds = "lists the sounds of a lesson, plays or writes them";
inline constexpr const char* kSoundsPlay = "play each behind its line.";
inline constexpr const char* kSoundsWav = "write each as a WAV file into this folder.";
inline constexpr const char* kSoundsFile =
    "a TOML file with sounds of your own. Default sounds.toml in the folder moontrace of your "
    "configuration, if it is there.";
inline constexpr const char* kOwnSounds = "with --sound, as of moontrace sounds.";
}  // namespace help

/// "stroke start".
std::string EarconName(Earcon earcon);
/// What it means, and how it sounds as shipped.
std::string EarconLine(Earcon earcon, bool on);
std::string PathSoundLine(bool on);
/// The line beside an earcon of the tip's path; empty for those that need none.
std::string OnThePath(Earcon earcon);

// Why nothing is heard: one sentence each, said once; the lesson goes on in text.
std::string NoSoundLibrary();
std::string NoSoundOutput(std::string_view cause);
std::string SoundGone();

}  // namespace moontrace::say
