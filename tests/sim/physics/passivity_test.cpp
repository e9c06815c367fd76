#include "sim/physics/passivity.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

TEST(PassivityObserver, SeesNothingWhenTheStorePaysForTheWork) {
  PassivityObserver observer;
  observer.Rebase(0.0);
  for (int cycle = 0; cycle < 100; ++cycle) {
    observer.Add(-0.002, 0.002);
    observer.Add(0.002, 0.0);
  }
  EXPECT_EQ(observer.energy_out(), 0);
}

TEST(PassivityObserver, LetsLossesPayForNothingLater) {
  PassivityObserver observer;
  observer.Rebase(0.0);
  observer.Add(-0.010, 0.0);  // dissipated
  observer.Add(0.001, 0.0);   // created, however much was lost before
  EXPECT_NEAR(observer.energy_out(), 0.001, 1e-18);
}

TEST(PassivityObserver, AddsUpWhatIsCreatedAgainAndAgain) {
  PassivityObserver observer;
  observer.Rebase(0.5);
  for (int i = 0; i < 1000; ++i) observer.Add(1e-6, 0.5);
  EXPECT_NEAR(observer.energy_out(), 1e-3, 1e-15);
}

TEST(PassivityObserver, GoesOnAfterAJumpOfTheStore) {
  PassivityObserver observer;
  observer.Rebase(0.0);
  observer.Add(0.001, 0.0);
  observer.Rebase(7.0);  // another page under the tip
  observer.Add(0.0, 7.0);
  EXPECT_EQ(observer.energy_out(), 0.001);
}

}  // namespace
}  // namespace moontrace
