#include "devices/hid/wooden_haptics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>
#include <glm/mat3x3.hpp>
#include <random>
#include <string>

#include "tests/source_path.h"

namespace moontrace {
namespace {

ArmGeometry Arm(const char* name) {
  return LoadProfile(SourcePath(std::string("devices/profiles/") + name + ".toml")).arm;
}

constexpr double kRight = 1.5707963267948966;  // 90 degrees

TEST(ArmPosition, IsWhereTheLinksLeadInTheRest) {
  const ArmGeometry arm = Arm("woodenhaptics");
  // B upright, C level towards the person: 245 mm out and 80 + 205 mm up; the middle of the
  // workspace is 220 mm out and 80 mm up.
  const glm::dvec3 p = ArmPosition(arm, {0, 0, kRight});
  EXPECT_NEAR(p.x, 0, 1e-12);
  EXPECT_NEAR(p.y, -0.025, 1e-12);  // y of frame D points away from the person
  EXPECT_NEAR(p.z, 0.205, 1e-12);
}

TEST(ArmPosition, GoesRightAsBodyATurns) {
  const ArmGeometry arm = Arm("woodenhaptics");
  const glm::dvec3 p = ArmPosition(arm, {kRight, 0, kRight});
  EXPECT_NEAR(p.x, 0.245, 1e-12);
  EXPECT_NEAR(p.y, 0.220, 1e-12);
}

TEST(ArmJacobian, IsTheDerivativeOfThePosition) {
  const ArmGeometry arm = Arm("woodenhaptics");
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-1, 1);
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 200; ++i) {
    const ArmAngles t = {angle(random), angle(random), 0.6 + angle(random)};
    const glm::dmat3 jacobian = ArmJacobian(arm, t);
    for (std::size_t k = 0; k < 3; ++k) {
      ArmAngles more = t, less = t;
      more[k] += kStep;
      less[k] -= kStep;
      const glm::dvec3 slope = (ArmPosition(arm, more) - ArmPosition(arm, less)) / (2 * kStep);
      // Central differences err by step^2/6 of the third derivative, below 1e-11 m.
      EXPECT_NEAR(glm::length(slope - jacobian[static_cast<int>(k)]), 0, 1e-9);
    }
  }
}

TEST(AnglesAt, CountsEdgesThroughTheCapstanAndAcrossTheWrap) {
  const ArmGeometry arm = Arm("woodenhaptics");
  // 2000 counts a turn of the motor, 16 and 12 turns for one of the body, falling as it grows.
  const ArmCounts rest = {32000, 32000, 32000};
  const ArmCounts counts = {static_cast<std::int16_t>(32000 - 32000 / 4),
                            static_cast<std::int16_t>(32000 + 6000 - 65536), 32000};
  const ArmAngles angles = AnglesAt(arm, counts, rest);
  EXPECT_NEAR(angles[0], kRight, 1e-12);
  EXPECT_NEAR(angles[1], -kRight, 1e-12);
  EXPECT_NEAR(angles[2], kRight, 1e-12);  // the rest itself
}

TEST(CurrentsFor, LiftsThroughBodyCInTheRest) {
  const ArmGeometry arm = Arm("woodenhaptics");
  // 1 N up on a level forearm of 245 mm: 0.245 Nm / 12 / 25.9 mNm/A; A and B have no part in it.
  const ArmCurrents currents = CurrentsFor(arm, {0, 0, kRight}, {0, 0, 1});
  EXPECT_NEAR(currents[0], 0, 1e-12);
  EXPECT_NEAR(currents[1], 0, 1e-12);
  EXPECT_NEAR(currents[2], 0.245 / 12 / 0.0259, 1e-12);
}

TEST(CurrentsFor, TurnsWithTheProfilesSign) {
  const ArmCurrents currents = CurrentsFor(Arm("polhem"), {0, 0, kRight}, {1, 0, 0});
  // 1 N to the right at 133 mm from the upright: 18 : 1, 53.8 mNm/A, the motor turned round.
  EXPECT_NEAR(currents[0], -0.133 / 18 / 0.0538, 1e-12);
}

TEST(CurrentsFor, DoesTheWorkThatTheForceDoes) {
  const ArmGeometry arm = Arm("polhem");
  const ArmAngles t = {0.3, 0.2, 0.9};
  const glm::dvec3 force(0.5, -1.2, 0.7);
  const ArmCurrents currents = CurrentsFor(arm, t, force);
  // Virtual work: torques times turned angles is force times way, for any small turn.
  const ArmAngles turn = {1e-6, -2e-6, 3e-6};
  double work = 0;
  ArmAngles turned = t;
  for (std::size_t i = 0; i < 3; ++i) {
    work += arm.current_sign[i] * currents[i] * arm.motor_constant[i] * arm.reduction[i] * turn[i];
    turned[i] += turn[i];
  }
  const glm::dvec3 way = ArmPosition(arm, turned) - ArmPosition(arm, t);
  EXPECT_NEAR(work, glm::dot(force, way), 1e-11);  // second order of the turn
}

TEST(CurrentsFor, KeepsTheDirectionAtThePeakCurrent) {
  const ArmGeometry arm = Arm("woodenhaptics");
  const ArmAngles t = {0.2, 0.3, 0.8};
  const ArmCurrents one = CurrentsFor(arm, t, {1, 2, -1});
  const ArmCurrents many = CurrentsFor(arm, t, {100, 200, -100});
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) most = std::max(most, std::abs(many[i]));
  EXPECT_NEAR(most, 3, 1e-12);
  EXPECT_NEAR(many[0] * one[1], many[1] * one[0], 1e-12);
  EXPECT_NEAR(many[2] * one[1], many[1] * one[2], 1e-12);
}

TEST(CurrentsFor, GivesNoneForWhatIsNoNumber) {
  const ArmCurrents currents =
      CurrentsFor(Arm("woodenhaptics"), {0, 0, kRight}, {0, std::nan(""), 1});
  EXPECT_EQ(currents, ArmCurrents{});
}

TEST(IsReachable, HoldsInTheRestAndNotBehindTheBase) {
  const ArmGeometry arm = Arm("woodenhaptics");
  EXPECT_TRUE(IsReachable(arm, arm.rest));
  EXPECT_FALSE(IsReachable(arm, {0, -1.5, 0}));
  EXPECT_FALSE(IsReachable(arm, {2, 0, kRight}));
  EXPECT_FALSE(IsReachable(arm, {0, 1, -1}));
}

TEST(DecodeArm, ReadsBothGenerations) {
  const ArmGeometry wooden = Arm("woodenhaptics");
  const std::array<std::uint8_t, 8> old = {0x01, 0x00, 0xFF, 0xFF, 0x10, 0x27, 0x05, 0x01};
  const auto report = DecodeArm(wooden, old);
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->counts, (ArmCounts{1, -1, 10000}));
  EXPECT_EQ(report->counter, 0x0105);
  std::array<std::uint8_t, 14> newer{};
  newer[0] = 7;
  newer[6] = 0x10, newer[7] = 0x27;  // encoder d with 10000 added: the button
  const auto polhem = DecodeArm(Arm("polhem"), newer);
  ASSERT_TRUE(polhem.has_value());
  EXPECT_EQ(polhem->counts[0], 7);
  EXPECT_TRUE(polhem->button);
  EXPECT_FALSE(polhem->counter.has_value());
  EXPECT_FALSE(DecodeArm(wooden, newer).has_value());
  EXPECT_FALSE(DecodeArm(wooden, std::span(old).first(7)).has_value());
}

TEST(EncodeArm, WritesMilliamperesBehindAZero) {
  const ArmOutput wooden = EncodeArm(Arm("woodenhaptics"), {1.5, -0.25, 99});
  ASSERT_EQ(wooden.size, 9u);
  EXPECT_EQ(wooden.bytes[0], 0);
  EXPECT_EQ(wooden.bytes[1] | wooden.bytes[2] << 8, 1500);
  EXPECT_EQ(static_cast<std::int16_t>(wooden.bytes[3] | wooden.bytes[4] << 8), -250);
  EXPECT_EQ(wooden.bytes[5] | wooden.bytes[6] << 8, 3000);  // the peak current
  EXPECT_EQ(EncodeArm(Arm("polhem"), {}).size, 15u);
  EXPECT_EQ(EncodeArm(Arm("polhem-teensy"), {}).size, 65u);
}

}  // namespace
}  // namespace moontrace
