#include <fmt/core.h>

#include "sim/app/messages.h"
#include "sim/wording/words.h"

namespace moontrace::say {

std::string DemoWelcome(std::string_view word) {
  return fmt::format("Welcome to Moontrace. A simulated stylus will trace the word {}.", word);
}

std::string DemoWhatMoonIs() {
  return "Moon is a script of lines and curves, read by touch: here, as grooves.";
}

std::string DemoHand() {
  return "The simulated hand trembles and drifts; only the groove keeps it on the letters.";
}

std::string DemoCovered() {
  return "Covered is the share of all strokes that the stylus went along.";
}

std::string DemoSize(double size, const TrialResult& result) {
  const TraceMetrics& total = result.score.total;
  const std::string left = total.excursions == 0
                               ? "never left the groove"
                               : fmt::format("left the groove {}", Times(total.excursions));
  return fmt::format("{} mm letters: {} covered, mean error {} mm, {}.",
                     Short(kMillimetres * size, 1), Percent(total.coverage),
                     Short(kMillimetres * total.mean_error, 3), left);
}

std::string DemoBlank(double size, const TrialResult& result) {
  return fmt::format("Blank page: {} covered, mean error {} mm, same hand at {} mm.",
                     Percent(result.score.total.coverage),
                     Short(kMillimetres * result.score.total.mean_error, 2),
                     Short(kMillimetres * size, 1));
}

std::string DemoWhyBlank() { return "So it is the grooves that guide the hand."; }

std::string DemoPictures() { return "Pictures of all this are in the folder:"; }

std::string DemoNext() { return "Next, try your own text: moontrace trace \"your name\""; }

std::string DemoBelowBar(double size) {
  return fmt::format("the demo lost the {} mm letters: below 98 percent covered",
                     Short(kMillimetres * size, 1));
}

}  // namespace moontrace::say
