#include "sim/trial/touch_energy.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

TEST(TouchEnergy, IsNothingInTheAir) {
  TouchEnergy energy;
  energy.Add(1e-6, false);
  energy.Add(3e-6, false);
  EXPECT_EQ(energy.value(), 0);
}

TEST(TouchEnergy, IsWhatWasAddedInContact) {
  TouchEnergy energy;
  energy.Add(1e-6, true);
  energy.Add(4e-6, false);
  energy.Add(6e-6, true);
  energy.Add(0, false);  // another page's watch begins: what is gone is not put out again
  energy.Add(6e-6, true);
  EXPECT_NEAR(energy.value(), 3e-6, 1e-18);
}

}  // namespace
}  // namespace moontrace
