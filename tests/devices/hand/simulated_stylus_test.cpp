#include "devices/hand/simulated_stylus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <stdexcept>
#include <vector>

namespace moontrace {
namespace {

constexpr double kTick = 0.001;

/// The shipped hand's figures without tremor and drift.
HandModel SteadyHand() {
  HandModel hand;
  hand.mass = 0.1;
  hand.stiffness = 200;
  hand.damping = 3;
  hand.press = 1;
  hand.light_press = 0.2;
  hand.tremor_low = 8;
  hand.tremor_high = 12;
  hand.drift_wavelength = 0.15;
  hand.late_ticks = 1;
  return hand;
}

HandModel UnsteadyHand() {
  HandModel hand = SteadyHand();
  hand.tremor_rms = 1e-4;
  hand.drift = 0.06;
  return hand;
}

HandPath At(glm::dvec3 p, double press = 0) {
  HandPath path;
  path.points.push_back({0, p, press});
  return path;
}

HandPath Between(glm::dvec3 from, glm::dvec3 to, double duration, double press = 0) {
  HandPath path = At(from, press);
  path.points.push_back({duration, to, press});
  return path;
}

std::vector<glm::dvec3> Track(Device& device, int ticks, glm::dvec3 force = {0, 0, 0}) {
  std::vector<glm::dvec3> track;
  for (int i = 0; i < ticks; ++i) {
    DeviceState state;
    EXPECT_EQ(device.Read(state), DeviceStatus::kOk);
    EXPECT_DOUBLE_EQ(state.time, i * kTick);
    track.push_back(state.p_D);
    EXPECT_EQ(device.Write(force), DeviceStatus::kOk);
  }
  return track;
}

TEST(SimulatedStylus, AnswersAForceAsADampedOscillator) {
  const HandModel hand = SteadyHand();
  const auto device = MakeSimulatedStylus(hand, At({0.01, 0.02, 0.03}), kTick, 1);
  const double force = 0.8;
  const auto track = Track(*device, 800, {force, 0, 0});
  const double decay = hand.damping / (2 * hand.mass);
  const double omega = std::sqrt(hand.stiffness / hand.mass - decay * decay);
  for (int i = 0; i < 800; ++i) {
    const double t = std::max(0, i - 1) * kTick;  // late by one tick
    const double step =
        1 - std::exp(-decay * t) * (std::cos(omega * t) + decay / omega * std::sin(omega * t));
    // 800 ticks of rounding, some 1e-17 m each.
    ASSERT_NEAR(track[static_cast<std::size_t>(i)].x, 0.01 + force / hand.stiffness * step, 2e-14);
  }
  EXPECT_NEAR(track.back().y, 0.02, 1e-16);
  EXPECT_NEAR(track.back().z, 0.03, 1e-16);
}

TEST(SimulatedStylus, FollowsAMovingAimWithoutALag) {
  const HandModel hand = SteadyHand();
  const auto device = MakeSimulatedStylus(hand, Between({0, 0, 0}, {0, 0.1, 0}, 2), kTick, 1);
  const auto track = Track(*device, 2000);
  const double decay = 15, omega = std::sqrt(2000.0 - 225.0), speed = 0.05;
  for (int i = 0; i < 2000; ++i) {
    const double t = i * kTick;
    const double expected = speed * (t - std::exp(-decay * t) * std::sin(omega * t) / omega);
    ASSERT_NEAR(track[static_cast<std::size_t>(i)].y, expected, 2e-14);
  }
}

TEST(SimulatedStylus, KeepsTheLastAimBeyondThePath) {
  const auto device =
      MakeSimulatedStylus(SteadyHand(), Between({0, 0, 0}, {0.01, 0, 0}, 0.3), kTick, 1);
  // The ringing dies with exp(-15 t): after 2.7 s less than 1e-17.
  EXPECT_NEAR(Track(*device, 3000).back().x, 0.01, 1e-15);
}

TEST(SimulatedStylus, FeelsAForceExactlySoManyTicksLate) {
  for (int late = 0; late <= 4; ++late) {
    HandModel hand = SteadyHand();
    hand.late_ticks = late;
    const auto device = MakeSimulatedStylus(hand, At({0, 0, 0}), kTick, 1);
    EXPECT_EQ(device->Limits().late_ticks, late);
    // One force, written after Read 5 and taken back after Read 6: it acts from tick 5 + late to
    // 6 + late, so Read 6 + late is the first that shows it, by f h^2 / 2m to first order.
    DeviceState state;
    for (int n = 0; n < 14; ++n) {
      device->Read(state);
      if (n < 6 + late) {
        EXPECT_EQ(state.p_D, glm::dvec3(0, 0, 0)) << n;
      } else if (n == 6 + late) {
        // The next order of the series is b h / 3m = 1 % smaller.
        EXPECT_NEAR(state.p_D.x, kTick * kTick / (2 * hand.mass), 0.011 * 5e-6);
      } else {
        EXPECT_GT(state.p_D.x, 5e-6);
      }
      device->Write({n == 5 ? 1.0 : 0.0, 0, 0});
    }
  }
}

TEST(SimulatedStylus, TakesAForceThatIsNotFiniteForNone) {
  const auto device = MakeSimulatedStylus(SteadyHand(), At({0, 0, 0}), kTick, 1);
  const auto track = Track(*device, 20, {std::nan(""), 0, 0});
  EXPECT_EQ(track.back(), glm::dvec3(0, 0, 0));
}

TEST(SimulatedStylus, PressesWithForceAndDampingOnly) {
  const HandModel hand = SteadyHand();
  HandPath path = At({0, 0, 0}, 1.0);
  const double tilt = 0.4;
  path.press_direction_D = {0, std::sin(tilt), -std::cos(tilt)};
  const auto device = MakeSimulatedStylus(hand, path, kTick, 1);
  const auto track = Track(*device, 55);
  for (int i = 0; i < 55; ++i) {  // a centimetre
    const double t = i * kTick, decay = hand.damping / hand.mass;
    const double depth = (t + std::expm1(-decay * t) / decay) / hand.damping;
    const glm::dvec3 expected = depth * path.press_direction_D;
    ASSERT_LT(glm::length(track[static_cast<std::size_t>(i)] - expected), 1e-14);
  }
}

// On its spring: 10 mm below where it means to press, and as far as that gives under the press.
TEST(SimulatedStylus, StopsSoonWhereNothingHoldsIt) {
  const HandModel hand = SteadyHand();
  const double press = 2.0, rests = -(0.010 + press / hand.stiffness);
  const auto track = Track(*MakeSimulatedStylus(hand, At({0, 0, 0.001}, press), kTick, 1), 3000);
  EXPECT_NEAR(track.back().z, 0.001 + rests, 1e-9);
  // it comes with b v = press at most, of which the spring takes the rest
  const double over = press / hand.damping * std::sqrt(hand.mass / hand.stiffness);
  for (const glm::dvec3& p : track) EXPECT_GT(p.z, 0.001 + rests - over);
}

TEST(SimulatedStylus, RestsOnAReactionEqualToThePress) {
  const auto device = MakeSimulatedStylus(SteadyHand(), At({0, 0, 0}, 1.0), kTick, 1);
  DeviceState state;
  for (int i = 0; i < 3000; ++i) {
    device->Read(state);
    device->Write({0, 0, state.p_D.z < 0 ? -1000 * state.p_D.z : 0});
  }
  EXPECT_NEAR(state.p_D.z, -1e-3, 1e-9);  // 1 N on 1000 N/m
}

TEST(SimulatedStylus, LiftsFromWhereItIsAndFindsBackToThePath) {
  HandPath path = At({0, 0, 0}, 0.5);
  path.points.push_back({0.2, {0, 0, 0}, 0.5});
  path.points.push_back({0.2005, {0, 0, 0}, 0});
  const auto device = MakeSimulatedStylus(SteadyHand(), path, kTick, 1);
  const auto track = Track(*device, 3000);
  const double sunk = track[201].z, speed = (track[201].z - track[200].z) / kTick;
  ASSERT_LT(sunk, -0.01);
  // The spring starts slack: the pull grows with the cube of time from the relaxing aim,
  // b w^2 |sunk| t^3 / 6m, while the damper only slows the sinking.
  for (int i = 1; i <= 5; ++i) {
    const double t = i * kTick;
    const double pull = 3 * 2000 * std::abs(sunk) * t * t * t / 0.6;
    const double slowing = 3 * std::abs(speed) * t * t / 0.2;
    const double coasting = sunk + speed * t;
    EXPECT_NEAR(track[static_cast<std::size_t>(201 + i)].z, coasting, pull + slowing + 2e-5);
  }
  EXPECT_NEAR(track.back().z, 0, 1e-9);
}

TEST(SimulatedStylus, RepeatsToTheBitWithTheSameSeedOnly) {
  const HandPath path = Between({0, 0, 0}, {0.1, 0.05, 0}, 2, 0.5);
  const auto run = [&](std::uint64_t seed) {
    return Track(*MakeSimulatedStylus(UnsteadyHand(), path, kTick, seed), 2000, {0.1, 0, 0.5});
  };
  const auto a = run(11), b = run(11), c = run(12);
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])), 0);
  EXPECT_GT(glm::length(a.back() - c.back()), 1e-5);
}

/// Mean sideways place at the end of a free straight way: tremor averages out over its periods.
double EndOfFreeWay(std::uint64_t seed, double length, bool press) {
  const double duration = length / 0.04;
  HandPath path = Between({0, 0, 0}, {length, 0, 0}, duration, press ? 0.5 : 0.0);
  const auto device = MakeSimulatedStylus(UnsteadyHand(), path, kTick, seed);
  const int moving = static_cast<int>(std::lround(duration / kTick));
  DeviceState state;
  double sum = 0;
  for (int i = 0; i < moving + 2000; ++i) {
    device->Read(state);
    device->Write({0, 0, press ? 0.5 : 0.0});
    if (i >= moving + 1000) sum += state.p_D.y;
  }
  return sum / 1000;
}

TEST(SimulatedStylus, DriftsSidewaysOnlyWhilePressing) {
  double greatest = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const double aside = std::abs(EndOfFreeWay(seed, 0.1, true));
    // Six per cent of 100 mm, and what tremor (0.05 mm lines at 8 Hz and more, amplified at most
    // 1/(2 zeta) = 1.5 times) leaves in the mean of a second: 8 * 0.075 mm / (pi 8).
    EXPECT_LE(aside, 6e-3 + 0.024e-3);
    greatest = std::max(greatest, aside);
    EXPECT_LE(std::abs(EndOfFreeWay(seed, 0.1, false)), 0.024e-3);
  }
  EXPECT_GT(greatest, 1e-3);
}

TEST(SimulatedStylus, LooksTheSameOnATiltedPage) {
  const double tilt = 0.3;
  const glm::dvec3 up{0, -std::sin(tilt), std::cos(tilt)}, far{0, std::cos(tilt), std::sin(tilt)};
  HandPath level = Between({0, 0, 0}, {0.03, 0.02, 0.001}, 1), tilted = level;
  for (HandPoint& point : tilted.points) {
    const glm::dvec3 p = point.p_D;
    point.p_D = p.x * glm::dvec3(1, 0, 0) + p.y * far + p.z * up;
  }
  tilted.press_direction_D = -up;
  const auto a = Track(*MakeSimulatedStylus(UnsteadyHand(), level, kTick, 3), 1000);
  const auto b = Track(*MakeSimulatedStylus(UnsteadyHand(), tilted, kTick, 3), 1000);
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_LT(glm::length(a[i] - glm::dvec3(b[i].x, glm::dot(b[i], far), glm::dot(b[i], up))),
              1e-15);
  }
}

TEST(SimulatedStylus, RefusesPathsItCannotFollow) {
  const HandModel hand = SteadyHand();
  const auto make = [&](const HandPath& path, double tick) {
    MakeSimulatedStylus(hand, path, tick, 1);
  };
  EXPECT_THROW(make(HandPath{}, kTick), std::invalid_argument);
  EXPECT_THROW(make(At({0, 0, 0}), 0), std::invalid_argument);
  EXPECT_THROW(make(At({0, std::nan(""), 0}), kTick), std::invalid_argument);
  EXPECT_THROW(make(At({0, 0, 0}, -1), kTick), std::invalid_argument);
  EXPECT_THROW(make(Between({0, 0, 0}, {1, 0, 0}, 0), kTick), std::invalid_argument);
  HandPath crooked = At({0, 0, 0});
  crooked.press_direction_D = {0, 0, -2};
  EXPECT_THROW(make(crooked, kTick), std::invalid_argument);
  EXPECT_THROW(MakeSimulatedStylus(HandModel{}, At({0, 0, 0}), kTick, 1), std::invalid_argument);
}

}  // namespace
}  // namespace moontrace
