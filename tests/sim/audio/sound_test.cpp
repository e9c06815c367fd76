#include "sim/audio/sound.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <vector>

#include "tests/sim/sound_fixture.h"
#include "tests/sim/tutor_fixture.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

/// An output by hand, with what it shares with its test.
struct Hand {
  std::atomic<SoundSource*> source{nullptr};
  std::atomic<bool> alive{true}, release{false};
  std::atomic<int> closed{0};
};
class HandOutput final : public SoundOutput {
 public:
  explicit HandOutput(Hand& hand) : hand_(hand) {}
  ~HandOutput() override { ++hand_.closed; }
  bool Alive() noexcept override { return hand_.alive; }

 private:
  Hand& hand_;
};
OpenSoundOutput OpenHand(Hand& hand) {
  return [&hand](SoundSource& source) {
    hand.source = &source;
    return std::make_unique<HandOutput>(hand);
  };
}

double Loudness(Hand& hand, double seconds) {
  std::vector<float> frames(static_cast<std::size_t>(2 * seconds * kSoundRate));
  hand.source.load()->Render(frames.data(), frames.size() / 2);
  double sum = 0;
  for (const float value : frames) sum += value * value;
  return std::sqrt(sum / static_cast<double>(frames.size()));
}

std::string Sentence(Sound& sound) {
  std::optional<std::string> sentence;
  EXPECT_TRUE(Eventually([&] { return (sentence = sound.TakeSentence()).has_value(); }));
  EXPECT_FALSE(sound.TakeSentence()) << "said twice";
  return sentence.value_or("");
}

TEST(Sound, PutsOutTheWayAndEarcons) {
  Hand hand;
  {
    Sound sound(Shipped(), OpenHand(hand));
    ASSERT_TRUE(Eventually([&] { return sound.sounding(); }));
    EXPECT_EQ(Loudness(hand, 0.1), 0);
    sound.Follow({true, 0.5, 0.5, 0});
    EXPECT_GT(Loudness(hand, 0.1), 0.05);
    sound.Silence();
    Loudness(hand, 0.1);
    EXPECT_LT(Loudness(hand, 0.1), 1e-4);
    sound.Play(Earcon::kRight);
    EXPECT_GT(Loudness(hand, 0.1), 0.05);
    EXPECT_FALSE(sound.TakeSentence());
  }
  EXPECT_EQ(hand.closed, 1);
}

TEST(Sound, FallsSilentWhenTheLessonNoLongerTellsWhereTheTipIs) {
  Hand hand;
  Sound sound(Shipped(), OpenHand(hand));
  ASSERT_TRUE(Eventually([&] { return sound.sounding(); }));
  sound.Follow({true, 0.5, 0.5, 0});
  EXPECT_GT(Loudness(hand, 0.1), 0.05);
  for (int i = 0; i < 40; ++i) Loudness(hand, 0.01);
  EXPECT_LT(Loudness(hand, 0.1), 1e-4);
}

TEST(Sound, WithoutAnOutputIsOneSentenceAndNothingElse) {
  Sound sound(Shipped(), [](SoundSource&) -> std::unique_ptr<SoundOutput> {
    throw LackError("No sound, all is text: nothing is there.");
  });
  EXPECT_EQ(Sentence(sound), "No sound, all is text: nothing is there.");
  for (int i = 0; i < 1000; ++i) {
    sound.Play(Earcon::kRight);
    sound.Follow({true, 0, 0, 0});
  }
  sound.Silence();
  EXPECT_FALSE(sound.sounding());
}

TEST(Sound, WhoseOutputDiesIsOneSentence) {
  Hand hand;
  Sound sound(Shipped(), OpenHand(hand));
  ASSERT_TRUE(Eventually([&] { return sound.sounding(); }));
  hand.alive = false;
  EXPECT_EQ(Sentence(sound), "No more sound, all is text: the sound output has ended.");
  EXPECT_TRUE(Eventually([&] { return hand.closed == 1; }));
  EXPECT_FALSE(sound.sounding());
  sound.Play(Earcon::kRight);
}

TEST(Sound, EndsThoughItsOutputHangsWhileItOpens) {
  static Hand hand;  // outlives the thread that is left behind
  {
    const Sound sound(Shipped(), [](SoundSource&) -> std::unique_ptr<SoundOutput> {
      while (!hand.release) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      return std::make_unique<HandOutput>(hand);
    });
  }
  EXPECT_EQ(hand.closed, 0);
  hand.release = true;
  EXPECT_TRUE(Eventually([] { return hand.closed == 1; }));  // and is put away after all
}

}  // namespace
}  // namespace moontrace
