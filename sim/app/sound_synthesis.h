#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sim/app/path_sound.h"
#include "sim/app/sound_table.h"

namespace moontrace {

/// One earcon, mono at kSoundRate, within -1 to 1, without a step at any end: every note swells for
/// 5 ms and dies for 8 ms. No partial is above 5 kHz. A recording fades at its ends as notes do.
std::vector<float> RenderEarcon(const EarconSound& sound);

/// The tone of the way. A value type: copies sound alike.
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

/// All that is heard at a time: the way, and one earcon, during which the way is silent. What is
/// put out lies within -1 to 1 and has no steps. Nothing here allocates but the constructor.
class Mixer {
 public:
  explicit Mixer(const SoundTable& table);

  /// Plays an earcon after those that wait, of which each is heard for 0.15 s or to its end; the
  /// safety stop at once, and nothing that waited. More than three do not wait: the oldest goes.
  void Play(Earcon earcon) noexcept;
  /// Earcons end, faded.
  void Hush() noexcept;
  /// `count` pairs, left and right.
  void Render(float* frames, std::size_t count, const PathSound& path) noexcept;
  /// No earcon plays or waits.
  bool idle() const { return playing_ == kNone && waiting_count_ == 0; }

 private:
  static constexpr std::size_t kNone = kEarcons;
  static constexpr std::size_t kMostWaiting = 3;
  void Advance() noexcept;
  double NextOfEarcon() noexcept;

  double volume_;
  bool path_on_;
  std::array<std::vector<float>, kEarcons> sounds_;
  PathVoice voice_;
  std::size_t playing_ = kNone;
  std::size_t at_ = 0;   ///< frame of the one that plays
  double gain_ = 0;      ///< of the earcon; 1 - gain_ of the way
  bool fading_ = false;  ///< the one that plays gives way
  std::array<std::size_t, kMostWaiting> waiting_{};
  std::size_t waiting_count_ = 0;
};

}  // namespace moontrace
