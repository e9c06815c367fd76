#include "sim/setup/text_trial.h"

namespace moontrace {

void SetPress(const HandModel& hand, Relief relief, std::optional<double> press,
              PlanOptions& options) {
  options.press = press.value_or(relief == Relief::kEmbossed ? hand.light_press : hand.press);
  options.ridge_press = press.value_or(hand.light_press);
}

TrialSetup TrialOf(const TextSetup& text, std::size_t page, const FeelOptions& feel,
                   std::optional<double> press, std::uint64_t seed) {
  TrialSetup setup;
  setup.script = &text.script;
  setup.page = &text.set.pages[page];
  setup.style = text.set.style;
  setup.model_path = feel.model;
  setup.scene = OnLabel(text, page, feel.scene);
  setup.others = text.others;
  setup.hand = ShippedHand();
  SetPress(setup.hand, setup.style.relief, press, setup.plan);
  setup.seed = seed;
  return setup;
}

}  // namespace moontrace
