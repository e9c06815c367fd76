#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace moontrace {

/// What groove links join: nothing, the letters of each word, also words across their spaces.
enum class LinkReach { kNone, kLetters, kWords };

/// "none", "letters", "words"; none for other words.
std::optional<LinkReach> LinkReachOf(std::string_view name);
std::string NameOf(LinkReach reach);
inline constexpr const char* kLinkReaches = "none, letters, words";

/// Shallow grooves between letters, so that a line can be traced like cursive (the paper, section
/// 6). Their width is the square root of that share of the letters',
/// so that their curvature is the same and their slope less.
struct LinkStyle {
  LinkReach reach = LinkReach::kNone;
  /// Share of the letters' depth, above 0, at most 1. At 0.4 the shipped hand leaves a third of the
  /// links of 12 mm letters (SlowLinkedTracing), at 0.6 one in fifteen.
  double depth = 0.6;
  std::optional<double> gap;  ///< kept to strokes, rim to rim [m]; default a quarter of the width
  bool operator==(const LinkStyle&) const = default;
};

}  // namespace moontrace
