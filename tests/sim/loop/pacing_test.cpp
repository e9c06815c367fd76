#include "sim/loop/pacing.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace moontrace {
namespace {

/// Time passes by looking at it, by sleeping, and when a test says so.
class FakeClock final : public Clock {
 public:
  std::int64_t Now() noexcept override { return now += 100; }
  void SleepUntil(std::int64_t time) noexcept override {
    ++sleeps;
    now = std::max(now, time) + oversleep;
  }
  std::int64_t now = 5'000'000'000;
  std::int64_t oversleep = 20'000;  // [ns], within what is spun away
  int sleeps = 0;
};

constexpr std::int64_t kMillisecond = 1'000'000;
constexpr std::int64_t kLook = 200;  // [ns], of looking at the clock

TEST(Pacing, KeepsTheRateWithoutDrift) {
  for (const double rate : {250.0, 1000.0, 10000.0}) {
    FakeClock clock;
    Pacing pacing(clock, rate);
    const std::int64_t first = pacing.Wait().time;
    for (int i = 1; i <= 1000; ++i) {
      const Wake wake = pacing.Wait();
      EXPECT_EQ(wake.lost, 0U);
      EXPECT_LE(wake.lateness, kLook);
      EXPECT_NEAR(static_cast<double>(wake.time - first), 1e9 * i / rate, kLook);
    }
    EXPECT_EQ(clock.sleeps, 1000);
  }
}

TEST(Pacing, SkipsWhatItMissed) {
  FakeClock clock;
  Pacing pacing(clock, 1000);
  const std::int64_t first = pacing.Wait().time;
  clock.now += 3 * kMillisecond + kMillisecond / 2;
  const Wake late = pacing.Wait();
  // due at 1 ms, woken at 3.5 ms: those of 2 and 3 ms are lost
  EXPECT_EQ(late.lost, 2U);
  EXPECT_NEAR(static_cast<double>(late.lateness), 2.5e6, 2 * kLook);
  const Wake next = pacing.Wait();
  EXPECT_EQ(next.lost, 0U);
  EXPECT_NEAR(static_cast<double>(next.time - first), 4e6, kLook);
}

TEST(Pacing, ALateTickIsNotLost) {
  FakeClock clock;
  Pacing pacing(clock, 1000);
  const std::int64_t first = pacing.Wait().time;
  clock.now += kMillisecond + kMillisecond / 2;
  const Wake late = pacing.Wait();
  EXPECT_EQ(late.lost, 0U);
  EXPECT_NEAR(static_cast<double>(late.lateness), 0.5e6, 2 * kLook);
  EXPECT_NEAR(static_cast<double>(pacing.Wait().time - first), 2e6, kLook);
}

TEST(Pacing, HoldsTheRateToItsRange) {
  FakeClock clock;
  EXPECT_EQ(Pacing(clock, 1).period(), 4 * kMillisecond);
  EXPECT_EQ(Pacing(clock, 1e6).period(), kMillisecond / 10);
}

TEST(SteadyClock, SleepsNoShorterThanAsked) {
  SteadyClock clock;
  const std::int64_t until = clock.Now() + 2 * kMillisecond;
  clock.SleepUntil(until);
  EXPECT_GE(clock.Now(), until);
}

}  // namespace
}  // namespace moontrace
