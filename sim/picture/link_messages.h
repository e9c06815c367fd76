#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "textures/relief/groove_links.h"
#include "textures/typeset/style.h"

namespace moontrace {

/// Links of pages, places where none keeps the gap, and pairs that run into each other.
struct LinkCounts {
  std::size_t links = 0, missing = 0, crossings = 0;
};

}  // namespace moontrace

/// Sentences about groove links and about tracing without lifting.
namespace moontrace::say {

/// How many links there are, and how many the tip left, if that is known.
std::string Links(const LinkCounts& counts, const LinkStyle& style,
                  std::optional<std::size_t> left = {});
/// The same for the words beside a picture.
std::string LinksDrawn(const LinkCounts& counts);
/// The colour of links in the picture of a trace, and how many were left: " Pale blue: links."
std::string LinksTraced(std::size_t links, std::optional<std::size_t> left);
/// How often the tip left the page within a line, and how many lines there are.
std::string Lifts(std::size_t lifts, std::size_t lines);

namespace help {
inline constexpr const char* kLinks =
    "shallow grooves that join the letters: none, letters (of each word) or words (across spaces "
    "too). Default none.";
inline constexpr const char* kLinkDepth =
    "depth of links as a share of the letters', 0.05 to 1. Default 0.6.";
inline constexpr const char* kLinkGap =
    "what links keep clear of strokes, rim to rim, in mm. Default a quarter of the width.";
}  // namespace help

}  // namespace moontrace::say
