#include "devices/hand/aimed_stylus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <stdexcept>

namespace moontrace {
namespace {

constexpr double kTick = 0.001;
constexpr glm::dvec3 kDown{0, 0, -1};

/// The shipped hand's figures.
HandModel Hand() {
  HandModel hand;
  hand.mass = 0.1;
  hand.stiffness = 200;
  hand.damping = 3;
  hand.drift_wavelength = 0.1;
  hand.late_ticks = 1;
  return hand;
}

class AimedStylus : public testing::Test {
 protected:
  AimedStylus() : device_(MakeAimedStylus(Hand(), aims_, kDown, kTick)) {}

  /// Where the tip is after so many ticks under a force that springs from where the tip is.
  template <class Force>
  glm::dvec3 After(int ticks, Force force) {
    for (int i = 0; i < ticks; ++i) {
      EXPECT_EQ(device_->Read(state_), DeviceStatus::kOk);
      fastest_ = std::max(fastest_, glm::distance(state_.p_D, last_) / kTick);
      highest_ = std::max(highest_, state_.p_D.z);
      last_ = state_.p_D;
      EXPECT_EQ(device_->Write(force(state_.p_D)), DeviceStatus::kOk);
    }
    return state_.p_D;
  }
  glm::dvec3 After(int ticks) {
    return After(ticks, [](glm::dvec3) { return glm::dvec3(0, 0, 0); });
  }
  /// Paper at z = 0 of 1000 N/m.
  glm::dvec3 OnPaper(int ticks) {
    return After(ticks, [](glm::dvec3 p) { return glm::dvec3(0, 0, p.z < 0 ? -1000 * p.z : 0); });
  }

  std::shared_ptr<Mailbox<StylusAim>> aims_ = std::make_shared<Mailbox<StylusAim>>();
  std::unique_ptr<Device> device_;
  DeviceState state_;
  glm::dvec3 last_{0, 0, 0.005};
  double fastest_ = 0, highest_ = 0;
};

TEST_F(AimedStylus, HoversBeforeTheFirstAim) {
  const glm::dvec3 p = After(500);
  EXPECT_EQ(glm::dvec2(p), glm::dvec2(0, 0));
  EXPECT_GT(p.z, 0.001);
  EXPECT_DOUBLE_EQ(state_.time, 0.499);
}

TEST_F(AimedStylus, ComesToTheAim) {
  aims_->Put({{0.02, 0.03, 0}, 0});
  const glm::dvec3 p = After(2500);
  // what rings dies with exp(-15 t): e^-37 of some centimetres
  EXPECT_NEAR(p.x, 0.02, 1e-15);
  EXPECT_NEAR(p.y, 0.03, 1e-15);
  EXPECT_GT(p.z, 0.001);
}

TEST_F(AimedStylus, PressesAsHardAsIsAsked) {
  aims_->Put({{0.02, 0.03, 0}, 0.8});
  const glm::dvec3 p = OnPaper(4000);
  // paper of 1000 N/m and 3 N s/m holds 0.8 N at a depth of 0.8 mm
  EXPECT_NEAR(p.z, -0.8e-3, 1e-9);
  EXPECT_NEAR(p.x, 0.02, 1e-12);
}

TEST_F(AimedStylus, LiftsWhenNothingPresses) {
  aims_->Put({{0.02, 0.03, 0}, 0.8});
  OnPaper(3000);
  highest_ = -1;
  aims_->Put({{0.02, 0.03, 0}, 0});
  const glm::dvec3 p = OnPaper(2500);
  EXPECT_GT(p.z, 0.002);
  EXPECT_LT(highest_, 1.5 * p.z);  // it does not spring away
}

/// A groove along y that pulls its tip back with K towards x = 0, K as the flank of a deep groove.
TEST_F(AimedStylus, IsHeldByAGrooveAsSpringsInSeries) {
  constexpr double kGroove = 600;
  aims_->Put({{0.004, 0.03, 0}, 1});
  const glm::dvec3 p = After(6000, [](glm::dvec3 p_D) {
    return glm::dvec3(-kGroove * p_D.x, 0, p_D.z < 0 ? -1000 * p_D.z : 0);
  });
  // the hand's 200 N/m pull to 4 mm, the groove's 600 N/m to 0: 4 mm * 200 / 800
  EXPECT_NEAR(p.x, 0.001, 1e-9);
  EXPECT_NEAR(p.y, 0.03, 1e-9);
}

TEST_F(AimedStylus, FeelsAForceOneTickLate) {
  EXPECT_EQ(device_->Limits().late_ticks, 1);
  After(5);
  device_->Read(state_);
  device_->Write({1, 0, 0});  // acts from the next tick to the one after it
  device_->Read(state_);
  EXPECT_EQ(state_.p_D.x, 0);
  device_->Write({0, 0, 0});
  device_->Read(state_);
  // f h^2 / 2m, the next order of the series being 1 % of it
  EXPECT_NEAR(state_.p_D.x, 5e-6, 0.011 * 5e-6);
}

/// A mouse that leaves the window at one side comes back at another: no pen is drawn between.
TEST_F(AimedStylus, GoesFarThroughTheAirAndNotTooFast) {
  aims_->Put({{0, 0, 0}, 1});
  OnPaper(2000);
  fastest_ = 0;
  highest_ = -1;
  aims_->Put({{0.2, 0.1, 0}, 1});
  const glm::dvec3 p = OnPaper(4000);
  EXPECT_NEAR(p.x, 0.2, 1e-9);
  EXPECT_NEAR(p.z, -1e-3, 1e-9);
  EXPECT_GT(highest_, 0.002);
  // half of what the loop takes for a jump of the device (kFastestHand, 5 m/s)
  EXPECT_LT(fastest_, 2.5);
}

TEST_F(AimedStylus, LeavesOutWhatIsNoAim) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  aims_->Put({{0.01, 0, 0}, 0});
  After(2500);
  aims_->Put({{kNan, 0, 0}, 0});
  After(1);
  aims_->Put({{0.02, 0, 0}, -1});
  After(1);
  aims_->Put({{0.02, 0, 0}, kNan});
  device_->Write({kNan, 0, 0});
  EXPECT_NEAR(After(100).x, 0.01, 1e-12);
}

TEST_F(AimedStylus, RefusesWhatCannotBe) {
  HandModel limp = Hand();
  limp.stiffness = 0;
  EXPECT_THROW(MakeAimedStylus(limp, aims_, kDown, kTick), std::invalid_argument);
  EXPECT_THROW(MakeAimedStylus(Hand(), nullptr, kDown, kTick), std::invalid_argument);
  EXPECT_THROW(MakeAimedStylus(Hand(), aims_, {0, 0, -2}, kTick), std::invalid_argument);
  EXPECT_THROW(MakeAimedStylus(Hand(), aims_, kDown, 0), std::invalid_argument);
}

}  // namespace
}  // namespace moontrace
