#include "sim/view/view_messages.h"

#include <fmt/core.h>

#include "sim/console/wording.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

std::string ViewObeys(ViewWord word) {
  switch (word) {
    case ViewWord::kZoomIn:
      return "The view comes nearer.";
    case ViewWord::kZoomOut:
      return "The view goes farther away.";
    case ViewWord::kWholePage:
      return "The view shows the whole page.";
    case ViewWord::kFollow:
      return "The view follows the tip; end it by \"follow off\".";
    case ViewWord::kFollowOff:
      return "The view stays where it is.";
    case ViewWord::kPrintOn:
      return "Print letters are shown.";
    case ViewWord::kPrintOff:
      return "Print letters are hidden.";
    case ViewWord::kPlotsOn:
      return "Plots are shown.";
    case ViewWord::kPlotsOff:
      return "Plots are hidden.";
    case ViewWord::kPanelOn:
      return "The panel is shown.";
    case ViewWord::kPanelOff:
      return "The panel is hidden; bring it back by \"panel on\".";
    case ViewWord::kContrastOn:
      return "The view has high contrast.";
    case ViewWord::kContrastOff:
      return "The view has its usual colours.";
    case ViewWord::kLargeTextOn:
      return "The view has large text.";
    case ViewWord::kLargeTextOff:
      return "The view has text of the usual size.";
  }
  return {};
}

std::string ViewWholeModel() { return "The view shows the whole model."; }

std::string ViewLooksAt(std::string_view name) {
  return fmt::format("The view looks at {}.", OneLine(name, 60));
}

std::string ViewNames(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 40;
  std::vector<std::string> told;
  told.reserve(std::min(names.size(), kMost));
  for (const std::string& name : names) {
    if (told.size() < kMost) told.push_back(OneLine(name, 60));
  }
  std::string line = fmt::format("view NAME looks at: {}", Joined(told, ", "));
  if (names.size() > kMost) line += fmt::format(", and {} more", names.size() - kMost);
  return line.append(".");
}

std::string ViewRefuses(std::string_view why) {
  std::string line(why);
  if (!line.empty()) line[0] = line[0] == 't' ? 'T' : line[0];
  return line.ends_with('?') ? line : line.append(".");
}

std::string ViewLost() { return "the display was lost: the view is over, all else goes on"; }

std::string ViewStopped(const std::string& why) { return fmt::format("the view is over: {}", why); }

std::string ViewTooSmall() {
  return "the window is too small for its panel: make it larger, or use words and keys";
}

std::string ViewMinimised() {
  return "the window is minimised: nothing is drawn, all else goes on";
}

std::string ViewPress(double press) { return fmt::format("mouse presses {:.1f} N", press); }

}  // namespace moontrace::say
