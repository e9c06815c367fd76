#pragma once

#include <memory>
#include <optional>
#include <string>

#include "sim/app/earcon.h"
#include "sim/app/sound_table.h"

namespace moontrace {

/// Where the tip is on what it follows, to be heard: pan is x, pitch is y, and a rough tone grows
/// with the distance from the stroke.
struct PathSound {
  bool in_contact = false;  ///< false: silence
  double x = 0, y = 0;      ///< in the box of the letter or page, 0-1; held to that
  double off_line = 0;      ///< 0: on the stroke; 1: as far as the tone grows; held to that
};

/// The sounds of a lesson. Every call returns at once and none throws; the audio callback neither
/// allocates nor locks. Without sound hardware or library, or with a service that dies, one
/// sentence tells so (TakeSentence) and nothing is heard from then on.
class Sound {
 public:
  /// Opens the sound output in a thread of its own.
  explicit Sound(const SoundTable& table);
  ~Sound();
  Sound(const Sound&) = delete;
  Sound& operator=(const Sound&) = delete;

  /// Plays an earcon, unless it is switched off. One thread.
  void Play(Earcon earcon) noexcept;
  /// The newest place of the tip; whatever rate it is called at. One thread.
  void Follow(const PathSound& now) noexcept;
  /// No tone and no earcon, faded out within 20 ms.
  void Silence() noexcept;

  /// Why nothing is heard any more: one sentence, once.
  std::optional<std::string> TakeSentence();
  /// Sound is being put out.
  bool sounding() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace moontrace
