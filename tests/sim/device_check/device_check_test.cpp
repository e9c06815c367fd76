#include "sim/device_check/device_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/vec3.hpp>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace moontrace {
namespace {

/// Time that passes when somebody looks, so that a check of many seconds takes none.
class FastClock final : public Clock {
 public:
  std::int64_t Now() noexcept override { return now_ += 1000; }
  void SleepUntil(std::int64_t time) noexcept override { now_ = std::max(now_, time); }

 private:
  std::int64_t now_ = 1;
};

/// What a bench device does and what it was given; outlives the device.
struct Bench {
  DeviceLimits limits;
  std::vector<glm::dvec3> forces;
  int reads = 0;
  int lost_at = -1;           ///< read
  std::uint32_t buttons = 0;  ///< held while it is pushed
  bool is_silent = false;
  bool is_still = false;
  bool motors_off = false;
  bool is_open = false;

  Bench() {
    limits.dead_man = 0.01;
    limits.buttons = 2;
  }
  double Greatest() const {
    double greatest = 0;
    for (const glm::dvec3& f : forces) {
      greatest = std::max({greatest, std::abs(f.x), std::abs(f.y), std::abs(f.z)});
    }
    return greatest;
  }
  /// The axes and signs that were pushed along, in order, like "+x-x".
  std::string Order() const {
    std::string order;
    for (const glm::dvec3& f : forces) {
      for (int i = 0; i < 3; ++i) {
        if (f[i] == 0) continue;
        const std::string one = std::string(f[i] > 0 ? "+" : "-") + "xyz"[i];
        if (order.size() < 2 || order.substr(order.size() - 2) != one) order += one;
      }
    }
    return order;
  }
};

class BenchDevice final : public Device {
 public:
  explicit BenchDevice(Bench& bench) : bench_(bench) { bench_.is_open = true; }
  ~BenchDevice() override {
    bench_.forces.emplace_back(0.0);
    bench_.is_open = false;
  }
  DeviceLimits Limits() const noexcept override { return bench_.limits; }
  DeviceStatus Read(DeviceState& state) noexcept override {
    if (bench_.lost_at >= 0 && bench_.reads >= bench_.lost_at) return DeviceStatus::kLost;
    ++bench_.reads;
    if (bench_.motors_off) return DeviceStatus::kNotReady;
    if (bench_.is_silent) return DeviceStatus::kNoNewData;
    state.time = 1e-3 * bench_.reads;
    if (!bench_.is_still) state.p_D = 0.01 * glm::dvec3(std::sin(1e-3 * bench_.reads), 0, 0);
    state.buttons =
        bench_.forces.empty() || bench_.forces.back() == glm::dvec3(0.0) ? 0 : bench_.buttons;
    return DeviceStatus::kOk;
  }
  DeviceStatus Write(glm::dvec3 f_D) noexcept override {
    bench_.forces.push_back(f_D);
    return DeviceStatus::kOk;
  }

 private:
  Bench& bench_;
};

class DeviceCheck : public testing::Test {
 protected:
  /// Results by step, like "good, left out", with the given answers.
  std::string Check(const std::string& answers) {
    std::istringstream in(answers);
    std::ostringstream out, err;
    Console console(in, out, err, &stop);
    CheckedDevice checked;
    checked.name = "bench";
    checked.title = "test bench";
    checked.rests_silent = rests_silent;
    checked.open = [this] { return std::make_unique<BenchDevice>(bench); };
    CheckPlan plan;
    plan.push = 0.1;  // also the copy's, in real time
    FastClock clock;
    std::string results;
    const auto tell = [this](const std::string& line) { said += line + "\n"; };
    for (const CheckStep& step : CheckDevice(checked, plan, clock, tell, console)) {
      if (!results.empty()) results += ", ";
      results += step.result == StepResult::kGood     ? "good"
                 : step.result == StepResult::kFailed ? "failed"
                                                      : "left out";
    }
    EXPECT_FALSE(bench.is_open);
    EXPECT_EQ(bench.forces.back(), glm::dvec3(0.0));
    return results;
  }
  bool Said(const std::string& part) const { return said.find(part) != std::string::npos; }

  Bench bench;
  std::string said;
  std::atomic<bool> stop{false};
  bool rests_silent = false;
};

// Agreement, six directions, agreement to the dead-man, gone.
const std::string kAllYes = "yes\nyes\nyes\nyes\nyes\nyes\nyes\nyes\nyes\n";

TEST_F(DeviceCheck, PushesAlongEveryAxisGentlyAndPasses) {
  EXPECT_EQ(Check(kAllYes), "good, good, good, good");
  // Six directions, then the cap's push along the first axis.
  EXPECT_EQ(bench.Order(), "+x-x+y-y+z-z+x");
  EXPECT_LE(bench.Greatest(), 0.5);
  EXPECT_GT(bench.Greatest(), 0.49);
  EXPECT_TRUE(Said("Now to the right, 0.5 N."));
  EXPECT_TRUE(Said("3\n2\n1\nNow"));
}

TEST_F(DeviceCheck, PushesOnlyWhereTheDeviceCan) {
  bench.limits.pushes = {true, true, false};
  EXPECT_EQ(Check("yes\nyes\nyes\nyes\nyes\nno\n"), "good, good, good, left out");
  EXPECT_EQ(bench.Order(), "+x-x+y-y+x");
}

TEST_F(DeviceCheck, NeverPushesWithoutAnAnswer) {
  for (const std::string answers : {"", "no\n", "perhaps\nwhat\nok\n"}) {
    EXPECT_EQ(Check(answers), "good, left out, left out, left out") << answers;
    EXPECT_EQ(bench.Greatest(), 0) << answers;
  }
}

TEST_F(DeviceCheck, StopsPushingWhenAnswersEnd) {
  EXPECT_EQ(Check("yes\nyes\n"), "good, left out, left out, left out");
  EXPECT_EQ(bench.Order(), "+x-x");
}

TEST_F(DeviceCheck, FailsWhereThePushWentElsewhere) {
  EXPECT_EQ(Check("yes\nyes\nno\nyes\nyes\nyes\nyes\nyes\nno\n"), "good, failed, good, failed");
}

TEST_F(DeviceCheck, AButtonEndsThePushAtOnce) {
  bench.buttons = 1;
  EXPECT_EQ(Check(kAllYes), "good, left out, left out, left out");
  EXPECT_TRUE(Said("Stopped by a button"));
  int pushed = 0;
  for (const glm::dvec3& f : bench.forces) pushed += f == glm::dvec3(0.0) ? 0 : 1;
  EXPECT_EQ(pushed, 1);  // the tick after which the button was seen
}

TEST_F(DeviceCheck, EndsWhenTheDeviceIsLost) {
  bench.lost_at = 100;
  EXPECT_EQ(Check(kAllYes), "failed");
}

TEST_F(DeviceCheck, LeavesOutWhatADeviceCannotDo) {
  bench.limits.dead_man = 0;
  EXPECT_EQ(Check(kAllYes), "good, good, good, left out");
  EXPECT_TRUE(Said("never lets go by itself"));
  bench.limits.pushes = {false, false, false};
  EXPECT_EQ(Check(kAllYes), "good, left out, left out, left out");
}

TEST_F(DeviceCheck, NoReportIsAFailureButForOneThatRestsSilently) {
  bench.is_silent = true;
  bench.limits.pushes = {false, false, false};
  EXPECT_EQ(Check(""), "failed, left out, left out, left out");
  rests_silent = true;
  EXPECT_EQ(Check(""), "left out, left out, left out, left out");
}

// It may be dead, and nobody can tell from that: not passed.
TEST_F(DeviceCheck, AStillTipIsAFailure) {
  bench.is_still = true;
  EXPECT_EQ(Check("no\n").substr(0, 6), "failed");
  EXPECT_TRUE(Said("did not move"));
}

TEST_F(DeviceCheck, NeverPushesWhileTheMotorsAreOff) {
  bench.motors_off = true;
  EXPECT_EQ(Check(kAllYes), "left out, left out, left out, left out");
  EXPECT_EQ(bench.Greatest(), 0);
}

TEST_F(DeviceCheck, InterruptionLeavesZero) {
  stop = true;
  EXPECT_THROW(Check(kAllYes), Interrupted);
  EXPECT_EQ(bench.forces.back(), glm::dvec3(0.0));
  EXPECT_FALSE(bench.is_open);
}

}  // namespace
}  // namespace moontrace
