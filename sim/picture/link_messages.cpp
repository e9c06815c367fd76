#include "sim/picture/link_messages.h"

#include <fmt/core.h>

#include "sim/console/wording.h"

namespace moontrace::say {

std::string Links(const LinkCounts& counts, const LinkStyle& style,
                  std::optional<std::size_t> left) {
  const std::size_t links = counts.links;
  std::string line = fmt::format("Links: {}", links == 0 ? "none" : fmt::format("{}", links));
  if (links > 0 && left) {
    line += fmt::format(", {} of them left", *left == 0 ? "none" : fmt::format("{}", *left));
  }
  line += fmt::format(", {:.3g} of the letters' depth", style.depth);
  if (counts.crossings > 0) {
    line += fmt::format("; {}", Counted(counts.crossings, "pair crosses", "pairs cross"));
  }
  if (counts.missing == 0) return line + ".";
  return fmt::format("{}; no room for {}.", line, counts.missing);
}

std::string LinksDrawn(const LinkCounts& counts) {
  std::string words =
      fmt::format("{}, drawn thin and light.", Counted(counts.links, "link", "links"));
  if (counts.crossings > 0) {
    words += fmt::format(" {}.", Counted(counts.crossings, "pair crosses", "pairs cross"));
  }
  if (counts.missing == 0) return words;
  return fmt::format("{} No room for {}.", words, Counted(counts.missing, "more", "more"));
}

std::string LinksTraced(std::size_t links, std::optional<std::size_t> left) {
  if (links == 0) return {};
  if (!left) return " Pale blue: links.";
  return fmt::format(" Pale blue: links; {} of {} left.",
                     *left == 0 ? "none" : fmt::format("{}", *left), links);
}

std::string Lifts(std::size_t lifts, std::size_t lines) {
  return fmt::format("Lifted within lines: {}, {}.",
                     lifts == 1 ? "once" : fmt::format("{} times", lifts),
                     Counted(lines, "line", "lines"));
}

}  // namespace moontrace::say
