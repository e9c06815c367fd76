#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sim/audio/sound_synthesis.h"
#include "sim/audio/sound_table.h"

namespace moontrace {

/// All that is heard at a time: the tone of the path, and one earcon, during which the tone is
/// silent. What is put out lies within -1 to 1 and has no steps. Nothing here allocates but the
/// constructor.
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
  double gain_ = 0;      ///< of the earcon; 1 - gain_ is that of the path's tone
  bool fading_ = false;  ///< the earcon that plays is being faded out
  std::array<std::size_t, kMostWaiting> waiting_{};
  std::size_t waiting_count_ = 0;
};

}  // namespace moontrace
