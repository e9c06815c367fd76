#include "lessons/measure/pause_meter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace moontrace {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A scripted hand, a sample each ms.
class Hand {
 public:
  void Go(double speed, double time) {
    for (int i = 0; i < std::lround(1000 * time); ++i) {
      time_ += 0.001;
      x_ += 0.001 * speed;
      const double shake = tremor * std::sin(2 * kPi * 10 * time_);
      const PauseMeter::Step step = meter.Add(time_, {x_, shake});
      pauses += step.began;
      paused += step.time;
    }
  }
  PauseMeter meter;
  double tremor = 0;  // at 10 Hz [m]
  int pauses = 0;
  double paused = 0;  // [s]

 private:
  double time_ = 0, x_ = 0;
};

TEST(PauseMeter, CountsRestsOfMoreThanThreeTenths) {
  Hand hand;
  hand.Go(0.02, 1);
  hand.Go(0, 0.5);
  hand.Go(0.02, 1);
  hand.Go(0, 0.2);
  hand.Go(0.02, 1);
  hand.Go(0, 1);
  EXPECT_EQ(hand.pauses, 2);
  // Up to 0.6 mm of the way before and after belong to it: 30 ms at 20 mm/s.
  EXPECT_NEAR(hand.paused, 1.5, 3 * 0.03 + 0.002);
}

TEST(PauseMeter, SpeedBelowV0IsAPauseAndAboveIsNone) {
  Hand slow;
  slow.Go(0.9 * PauseMeter::kSpeed, 5);
  EXPECT_EQ(slow.pauses, 1);
  EXPECT_NEAR(slow.paused, 5, 0.01);
  Hand fast;
  fast.Go(1.1 * PauseMeter::kSpeed, 5);
  EXPECT_EQ(fast.pauses, 0);
  EXPECT_EQ(fast.paused, 0);
}

TEST(PauseMeter, IsNotEndedByTremor) {
  Hand hand;
  hand.tremor = 1.4e-4;  // the shipped hand's 0.1 mm rms: up to 9 mm/s
  hand.Go(0.02, 1);
  hand.Go(0, 2);
  hand.Go(0.02, 1);
  EXPECT_EQ(hand.pauses, 1);
  EXPECT_NEAR(hand.paused, 2, 0.07);
}

TEST(PauseMeter, ABreakBeginsAnew) {
  Hand hand;
  hand.Go(0, 0.25);
  hand.meter.Break();
  hand.Go(0, 0.25);
  EXPECT_EQ(hand.pauses, 0);
  hand.Go(0, 0.25);
  hand.meter.Break();
  hand.Go(0, 0.5);
  EXPECT_EQ(hand.pauses, 2);
}

}  // namespace
}  // namespace moontrace
