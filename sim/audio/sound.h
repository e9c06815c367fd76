#pragma once

#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "sim/audio/earcon.h"
#include "sim/audio/sound_output.h"
#include "sim/audio/sound_synthesis.h"
#include "sim/audio/sound_table.h"

namespace moontrace {

/// The sounds of a lesson. Every call returns at once and none throws; the audio callback neither
/// allocates nor locks. Without sound hardware or library, or with a service that dies, one
/// sentence says so (TakeSentence) and nothing is heard from then on.
class Sound {
 public:
  /// Opens the output in a thread of its own.
  explicit Sound(const SoundTable& table, OpenSoundOutput open = OpenPortAudio);
  ~Sound();
  Sound(const Sound&) = delete;
  Sound& operator=(const Sound&) = delete;

  /// Plays an earcon, unless it is switched off: after those before it, each of which is heard for
  /// 0.15 s at least; the safety stop at once. One thread.
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
  std::shared_ptr<State> state_;
  std::thread thread_;
};

}  // namespace moontrace
