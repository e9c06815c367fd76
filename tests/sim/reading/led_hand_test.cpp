#include "sim/reading/led_hand.h"

#include <gtest/gtest.h>

#include <glm/vec3.hpp>
#include <vector>

#include "sim/trial/trial.h"
#include "textures/field/field.h"

namespace moontrace {
namespace {

/// What a mind gets that wants the same whatever it feels: down, and slowly to the right.
std::vector<ReaderInput> Given(const TextureField& field, double delay) {
  LedHandSetup setup;
  setup.field = &field;
  setup.hand = ShippedHand();
  setup.senses.delay = delay;
  setup.start_P = {0.02, 0.02};
  LedHand hand(setup);
  std::vector<ReaderInput> given;
  for (int i = 0; i < 1500; ++i) {
    given.push_back(hand.Feel());
    hand.Lead({{2e-5 * i, 0, 0}, i < 200 ? 0 : 0.5});
  }
  return given;
}

TEST(LedHand, FeelsPlaceAndForceLate) {
  const TextureField flat;
  const auto at_once = Given(flat, 0), late = Given(flat, 0.120);
  for (std::size_t i = 120; i < late.size(); ++i) {
    ASSERT_EQ(late[i].tip, at_once[i - 120].tip) << i;
    ASSERT_EQ(late[i].force, at_once[i - 120].force) << i;
    ASSERT_EQ(late[i].time, at_once[i].time) << i;
  }
}

// On flat paper at rest the page carries the press.
TEST(LedHand, IsCarriedByThePaper) {
  const TextureField flat;
  const auto given = Given(flat, 0);
  EXPECT_NEAR(given.back().force.z, 0.5, 0.1);
  EXPECT_NEAR(given.back().tip.x, 2e-5 * 1500, 2e-3);  // behind by its muscles and its spring
}

}  // namespace
}  // namespace moontrace
