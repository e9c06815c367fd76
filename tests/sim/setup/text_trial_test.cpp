#include "sim/setup/text_trial.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

HandModel Hand() {
  HandModel hand;
  hand.press = 1;
  hand.light_press = 0.2;
  return hand;
}

TEST(SetPress, IsLightOnRidgesWhereNoneIsAsked) {
  PlanOptions engraved, embossed;
  SetPress(Hand(), Relief::kEngraved, std::nullopt, engraved);
  SetPress(Hand(), Relief::kEmbossed, std::nullopt, embossed);
  EXPECT_EQ(engraved.press, 1);
  EXPECT_EQ(engraved.ridge_press, 0.2);
  EXPECT_EQ(embossed.press, 0.2);
  EXPECT_EQ(embossed.ridge_press, 0.2);
}

TEST(SetPress, IsWhatIsAskedOnBoth) {
  for (const Relief relief : {Relief::kEngraved, Relief::kEmbossed}) {
    PlanOptions options;
    SetPress(Hand(), relief, 0.7, options);
    EXPECT_EQ(options.press, 0.7);
    EXPECT_EQ(options.ridge_press, 0.7);
  }
}

TEST(TrialOf, IsThePageThatWasAskedForByTheShippedHand) {
  TextSetup text;
  text.set.pages.resize(2);
  text.set.style.relief = Relief::kEmbossed;
  FeelOptions feel;
  feel.model = "page.xml";
  feel.scene.tilt = 0.3;
  const TrialSetup setup = TrialOf(text, 1, feel, 0.4, 9);
  EXPECT_EQ(setup.page, &text.set.pages[1]);
  EXPECT_EQ(setup.script, &text.script);
  EXPECT_EQ(setup.style.relief, Relief::kEmbossed);
  EXPECT_EQ(setup.model_path, "page.xml");
  EXPECT_EQ(setup.scene.tilt, 0.3);
  EXPECT_EQ(setup.hand.light_press, ShippedHand().light_press);
  EXPECT_EQ(setup.plan.press, 0.4);
  EXPECT_EQ(setup.seed, 9U);
}

}  // namespace
}  // namespace moontrace
