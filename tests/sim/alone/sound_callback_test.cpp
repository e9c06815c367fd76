// What the sound output's thread runs allocates nothing, whatever is asked of it. An executable of
// its own, since it replaces malloc; with sanitizers there is nothing to count.
#include <gtest/gtest.h>

#include <array>
#include <atomic>

#include "sim/audio/sound.h"
#include "tests/counted_memory.h"
#include "tests/sim/tutor_fixture.h"
#include "tests/source_path.h"

#ifdef MOONTRACE_COUNTED_MEMORY

namespace {
thread_local bool watched = false;
thread_local long allocations = 0;
}  // namespace

void OnAllocation() noexcept {
  if (watched) ++allocations;
}

namespace moontrace {
namespace {

class IdleOutput final : public SoundOutput {
 public:
  bool Alive() noexcept override { return true; }
};

TEST(SoundCallback, AllocatesNothing) {
  std::atomic<SoundSource*> source{nullptr};
  Sound sound(LoadSounds(SourcePath("sim/app/sounds.toml")), [&](SoundSource& asked) {
    source = &asked;
    return std::make_unique<IdleOutput>();
  });
  ASSERT_TRUE(Eventually([&] { return sound.sounding(); }));
  std::array<float, 512> frames{};
  float loudest = 0;
  watched = true;
  for (int i = 0; i < 4000; ++i) {  // 21 s of sound
    if (i % 37 == 0) sound.Play(AllEarcons()[static_cast<std::size_t>(i / 37) % kEarcons]);
    if (i % 500 == 499) sound.Silence();
    sound.Follow({i % 90 < 60, i % 100 / 100.0, i % 70 / 70.0, i % 30 / 30.0});
    source.load()->Render(frames.data(), frames.size() / 2);
    for (const float value : frames) loudest = std::max(loudest, value);
  }
  watched = false;
  EXPECT_EQ(allocations, 0);
  EXPECT_GT(loudest, 0.1F);
}

}  // namespace
}  // namespace moontrace

#endif
