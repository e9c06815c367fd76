#include "sim/audio/sound_mixer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sim/sound_fixture.h"

namespace moontrace {
namespace {

/// The greatest step from sample to sample, and the greatest value, of each side.
struct Steps {
  float step = 0, value = 0;
};
Steps StepsOf(const std::vector<float>& frames) {
  Steps steps;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    steps.value = std::max(steps.value, std::abs(frames[i]));
    const float before = i < 2 ? 0 : frames[i - 2];
    steps.step = std::max(steps.step, std::abs(frames[i] - before));
  }
  return steps;
}

TEST(Mixer, NeitherClipsNorClicksWhateverIsAskedOfIt) {
  SoundTable table = Shipped();
  table.volume = 1;
  // A sound whose partials all lie below 5 kHz and whose amplitude is at most 1 cannot step farther
  // than 2 pi 5000 / 48000 = 0.65; the shipped ones have little up there. A click would be a step
  // of the order of the loudness itself; so steps are compared with those of each sound by itself.
  float alone = 0;
  for (const Earcon earcon : AllEarcons()) {
    float before = 0;
    for (const float sample : Render(table, earcon)) {
      alone = std::max(alone, std::abs(sample - before));
      before = sample;
    }
  }
  Mixer mixer(table);
  std::vector<float> frames(2 * 48 * 3000);  // 3 s in blocks of 1 ms
  unsigned random = 1;
  for (std::size_t block = 0; block < 3000; ++block) {
    random = random * 1664525U + 1013904223U;
    if (random >> 24U < 10) mixer.Play(AllEarcons()[(random >> 8U) % kEarcons]);
    if (random >> 24U == 100) mixer.Hush();
    const bool touches = (block / 70) % 3 != 0;
    const double jumping = (block / 30) % 2 == 0 ? 0 : 1;
    mixer.Render(frames.data() + 96 * block, 48, {touches, jumping, 1 - jumping, jumping});
  }
  const Steps steps = StepsOf(frames);
  EXPECT_LE(steps.value, 1.0F);
  EXPECT_GT(steps.value, 0.3F);
  // the fade between way and earcon adds at most 1 / (5 ms) a sample
  EXPECT_LE(steps.step, alone + 1 / (0.005 * kSoundRate) + 0.06);
}

/// Blocks of 1 ms until the mixer is idle.
std::vector<float> Played(Mixer& mixer) {
  std::vector<float> left;
  for (int block = 0; block < 5000 && !(block > 0 && mixer.idle()); ++block) {
    float frames[96];
    mixer.Render(frames, 48, {});
    for (std::size_t i = 0; i < 48; ++i) left.push_back(frames[2 * i]);
  }
  return left;
}

TEST(Mixer, LetsEachEarconBeHeardBeforeTheNext) {
  const SoundTable table = Shipped();
  Mixer mixer(table);
  mixer.Play(Earcon::kStrokeEnd);
  mixer.Play(Earcon::kLetterDone);
  mixer.Play(Earcon::kRight);
  const std::vector<float> heard = Played(mixer);
  // 0.15 s of each of the first two and all of the last, with 5 ms to change
  const double whole = static_cast<double>(Render(table, Earcon::kRight).size()) / kSoundRate;
  EXPECT_NEAR(static_cast<double>(heard.size()) / kSoundRate, 0.3 + whole, 0.02);
  EXPECT_GT(AmplitudeAt(heard, 0, 7000, 330), 0.05);     // the stroke's end
  EXPECT_GT(AmplitudeAt(heard, 7400, 4000, 523), 0.05);  // the first bell
  EXPECT_GT(AmplitudeAt(heard, heard.size() - 9000, 8000, 1047), 0.05);
}

TEST(Mixer, StopsEverythingForTheSafetyStop) {
  const SoundTable table = Shipped();
  Mixer mixer(table), alone(table);
  mixer.Play(Earcon::kPageEnd);
  float frames[96];
  for (int block = 0; block < 20; ++block) mixer.Render(frames, 48, {});
  mixer.Play(Earcon::kRight);
  mixer.Play(Earcon::kSafetyStop);
  alone.Play(Earcon::kSafetyStop);
  const std::size_t extra = Played(mixer).size() - Played(alone).size();
  EXPECT_LE(extra, 0.006 * kSoundRate);  // 5 ms of fading, and a block
}

TEST(Mixer, PlaysNothingThatIsSwitchedOff) {
  SoundTable table = Shipped();
  table.earcons[static_cast<std::size_t>(Earcon::kRight)].on = false;
  table.path.on = false;
  Mixer mixer(table);
  mixer.Play(Earcon::kRight);
  EXPECT_TRUE(mixer.idle());
  std::vector<float> frames(9600);
  mixer.Render(frames.data(), 4800, {true, 0.5, 0.5, 1});
  EXPECT_EQ(StepsOf(frames).value, 0);
}

}  // namespace
}  // namespace moontrace
