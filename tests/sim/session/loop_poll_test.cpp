#include "sim/session/loop_poll.h"

#include <gtest/gtest.h>

#include "sim/session/loop_messages.h"

namespace moontrace {
namespace {

// Under load a device lets go again and again: "No force" was said each time, "back" never.
TEST(MotorsTold, AreToldOfOnceUntilForceIsThereAgain) {
  MotorsTold motors;
  EXPECT_FALSE(motors.IsBack(1, 2)) << "they were never off";
  EXPECT_TRUE(motors.WentOff(10));
  EXPECT_FALSE(motors.WentOff(11.5));
  EXPECT_FALSE(motors.IsBack(12, 1.5)) << "they flicker";
  EXPECT_FALSE(motors.WentOff(13));
  EXPECT_FALSE(motors.IsBack(60, 0)) << "nothing is pushed";
  EXPECT_TRUE(motors.IsBack(61, 0.2));
  EXPECT_FALSE(motors.IsBack(62, 0.2)) << "once";
  EXPECT_TRUE(motors.WentOff(70));
  motors.Lost();
  EXPECT_FALSE(motors.IsBack(80, 1)) << "what is said of a device that is back is enough";
}

TEST(MotorsTold, AreSummedUpAtTheEnd) {
  std::array<std::uint64_t, kSafetyEvents> counts{};
  counts[static_cast<std::size_t>(SafetyEvent::kNotReady)] = 5;
  EXPECT_EQ(say::Repeated(counts), "In all: the motors were off 5 times.");
}

}  // namespace
}  // namespace moontrace
