#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// What one can ask of the view, in words.
enum class ViewWord {
  kZoomIn,
  kZoomOut,
  kWholePage,
  kFollow,
  kFollowOff,
  kPrintOn,
  kPrintOff,
  kPlotsOn,
  kPlotsOff,
  kPanelOn,
  kPanelOff,
  kContrastOn,
  kContrastOff,
  kLargeTextOn,
  kLargeTextOff
};

/// "zoom in" and so on; spaces around and capitals do not count. None: no word of the view.
std::optional<ViewWord> ViewWordOf(std::string_view line);

/// "view mug" asks to look at "mug", "view" alone for what there is: empty. None: neither.
std::optional<std::string> ViewedNameOf(std::string_view line);

/// All words, for help.
const std::vector<std::string>& ViewWords();

}  // namespace moontrace
