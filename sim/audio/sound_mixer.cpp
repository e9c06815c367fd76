#include "sim/audio/sound_mixer.h"

#include <algorithm>
#include <numbers>

namespace moontrace {

namespace {

constexpr double kChange = 0.005;       // between the tone and an earcon [s]
constexpr double kHeardAtLeast = 0.15;  // of an earcon before the next [s]

}  // namespace

Mixer::Mixer(const SoundTable& table)
    : volume_(table.volume), path_on_(table.path.on), voice_(table.path) {
  for (std::size_t i = 0; i < kEarcons; ++i) {
    if (table.earcons[i].on) sounds_[i] = RenderEarcon(table.earcons[i]);
  }
}

void Mixer::Play(Earcon earcon) noexcept {
  const auto index = static_cast<std::size_t>(earcon);
  if (sounds_[index].empty()) return;
  if (earcon == Earcon::kSafetyStop) {
    waiting_count_ = 0;
    fading_ = playing_ != kNone;
  }
  if (waiting_count_ == kMostWaiting) {
    std::copy(waiting_.begin() + 1, waiting_.end(), waiting_.begin());
    --waiting_count_;
  }
  waiting_[waiting_count_++] = index;
}

void Mixer::Hush() noexcept {
  waiting_count_ = 0;
  fading_ = playing_ != kNone;
}

/// To the next earcon, once the one that plays has ended or faded away.
void Mixer::Advance() noexcept {
  if (playing_ != kNone) {
    const bool heard = static_cast<double>(at_) >= kHeardAtLeast * kSoundRate;
    fading_ = fading_ || (waiting_count_ > 0 && heard);
    if (at_ < sounds_[playing_].size() && (!fading_ || gain_ > 0)) return;
    playing_ = kNone;
    fading_ = false;
  }
  if (waiting_count_ == 0) return;
  playing_ = waiting_[0];
  at_ = 0;
  std::copy(waiting_.begin() + 1, waiting_.end(), waiting_.begin());
  --waiting_count_;
}

double Mixer::NextOfEarcon() noexcept {
  constexpr double kStep = 1 / (kChange * kSoundRate);
  const bool sounds = playing_ != kNone && !fading_;
  gain_ = std::clamp(gain_ + (sounds ? kStep : -kStep), 0.0, 1.0);
  return playing_ == kNone || at_ >= sounds_[playing_].size() ? 0 : sounds_[playing_][at_++];
}

void Mixer::Render(float* frames, std::size_t count, const PathSound& path) noexcept {
  PathSound heard = path;
  heard.in_contact = path_on_ && path.in_contact;
  for (std::size_t i = 0; i < count; ++i) {
    Advance();
    const double earcon = NextOfEarcon();
    const PathVoice::Frame tone = voice_.Next(heard);
    // an earcon comes from the middle, as loud as a tone panned there
    const double middle = gain_ * earcon * std::numbers::sqrt2 / 2;
    frames[2 * i] = static_cast<float>(volume_ * ((1 - gain_) * tone.left + middle));
    frames[2 * i + 1] = static_cast<float>(volume_ * ((1 - gain_) * tone.right + middle));
  }
}

}  // namespace moontrace
