#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <random>

#include "sim/safety/safety.h"

namespace moontrace {
namespace {

constexpr double kTick = 0.001;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr glm::dvec3 kZero{0, 0, 0};

/// Whatever numbers there are, most of them sane so that force flows at times.
struct Hostile {
  explicit Hostile(unsigned seed) : random(seed) {}
  double Number(double scale) {
    constexpr double kOdd[] = {0, -0.0, kNan, kInfinity, -kInfinity, 1e308, -1e308, 5e-324, 1e18};
    if (Chance(0.0002)) return kOdd[random() % 9];
    return scale * std::uniform_real_distribution<double>(-1, 1)(random);
  }
  bool Chance(double share) { return std::uniform_real_distribution<double>(0, 1)(random) < share; }
  std::mt19937 random;
};

void MakeHostile(Hostile& hostile, SafetyInput& input, glm::dvec3& p) {
  for (int axis = 0; axis < 3; ++axis) {
    input.force[axis] = hostile.Number(hostile.Chance(0.2) ? 20 : 2);
    p[axis] = std::clamp(p[axis] + 1e-3 * hostile.Number(1), -0.1, 0.1);
    input.device.p_D[axis] = hostile.Chance(0.0002) ? hostile.Number(10) : p[axis];
    input.device.v_D[axis] = hostile.Number(hostile.Chance(0.001) ? 10 : 1);
  }
  input.device.velocity_known = hostile.Chance(0.5);
  input.time += hostile.Chance(0.001) ? hostile.Number(0.02) : kTick;
  input.status =
      hostile.Chance(0.002) ? static_cast<DeviceStatus>(hostile.random() % 4) : DeviceStatus::kOk;
  input.physics_fault = hostile.Chance(0.0005);
  input.stop = hostile.Chance(0.0005);
  input.go_on = hostile.Chance(0.01);
  input.ramp = hostile.Chance(0.001);
  input.hold = hostile.Chance(0.001);
}

bool MustBeZero(const SafetyInput& in, const SafetyResult& out) {
  bool finite = std::isfinite(in.time);
  for (int axis = 0; axis < 3; ++axis) {
    finite = finite && std::isfinite(in.force[axis]) && std::isfinite(in.device.p_D[axis]);
  }
  return !finite || in.status == DeviceStatus::kLost || in.status == DeviceStatus::kNotReady ||
         in.physics_fault || in.stop || in.hold || in.ramp || out.stopped;
}

TEST(Safety, HoldsItsPromisesUnderHostileInput) {
  int flowing = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Hostile hostile(seed);
    DeviceLimits limits;
    limits.peak_force = 5;
    limits.continuous_force = 1;
    limits.heat_time = 0.5;
    limits.peak_power = 3;
    limits.pushes.y = seed % 3 != 0;
    Safety safety(limits, kTick, 0.05);
    SafetyInput input;
    glm::dvec3 p{0, 0, 0}, last{0, 0, 0};
    for (int n = 0; n < 20000; ++n) {
      MakeHostile(hostile, input, p);
      const SafetyResult result = safety.Advance(input);
      for (int axis = 0; axis < 3; ++axis) {
        const double f = result.force[axis];
        ASSERT_TRUE(std::isfinite(f));
        ASSERT_LE(std::abs(f), limits.pushes[axis] ? result.ceiling[axis] + 1e-9 : 0);
        ASSERT_LE(result.ceiling[axis], limits.peak_force);
        ASSERT_TRUE(std::isfinite(result.heat[axis]));
        // a rise is at most 3 N from the last command, or from zero after a change of sign
        ASSERT_LE(std::abs(f), (f * last[axis] > 0 ? std::abs(last[axis]) : 0) + 3 + 1e-9);
        // a fall is never delayed: never more than is wanted, never against it
        if (f == 0) continue;
        ASSERT_LE(std::abs(f), std::abs(input.force[axis]) + 1e-12);
        ASSERT_GE(f * input.force[axis], 0);
      }
      ASSERT_TRUE(result.force == kZero || !MustBeZero(input, result)) << seed << ' ' << n;
      if (input.device.velocity_known && result.force != kZero) {
        ASSERT_LE(glm::dot(result.force, input.device.v_D), limits.peak_power + 1e-9);
      }
      if (result.force != kZero) ++flowing;
      last = result.force;
      if (!std::isfinite(input.time) || std::abs(input.time) > 1e6) input.time = n * kTick;
    }
  }
  EXPECT_GT(flowing, 40000);  // of 400000 ticks: else little was tested
}

}  // namespace
}  // namespace moontrace
