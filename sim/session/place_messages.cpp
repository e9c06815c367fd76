#include "sim/session/place_messages.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/console/wording.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

std::string Way(glm::dvec2 way_P) {
  std::vector<std::string> parts;
  const auto add = [&parts](double way, std::string_view low, std::string_view high) {
    const double mm = kMillimetres * std::abs(way);
    if (mm >= 0.5) parts.push_back(fmt::format("{} mm {}", Short(mm, 1), way < 0 ? low : high));
  };
  add(way_P.x, "left", "right");
  add(way_P.y, "down", "up");
  return parts.empty() ? "under the tip" : Joined(parts, ", ");
}

std::string PlaceIs(std::string_view what, std::size_t page, std::size_t pages, std::size_t line,
                    std::optional<glm::dvec2> way_P) {
  std::string place = pages > 1 ? fmt::format("page {} of {}, ", page + 1, pages) : "";
  place += fmt::format("line {}", line + 1);
  if (way_P) place += ", " + Way(*way_P);
  // a sentence leaves its own full stop for that of the whole
  while (what.ends_with('.')) what.remove_suffix(1);
  if (!what.empty()) return fmt::format("{}: {}.", what, place);
  place[0] = static_cast<char>(place[0] - 'a' + 'A');
  return place + ".";
}

std::string Occurrence(std::string_view wanted, std::size_t number, std::size_t of) {
  return fmt::format("{}, {} of {}", OneLine(wanted, 16), number, of);
}

std::string HeadingIs(std::string_view line) {
  return fmt::format("Heading {}", OneLine(line, 24));
}

std::string ParagraphIs(std::string_view line) {
  return fmt::format("Paragraph {}", OneLine(line, 20));
}

std::string LinkIs(std::string_view words) { return fmt::format("Link {}", OneLine(words, 24)); }

std::string BackAt(std::string_view letter) {
  return letter.empty() ? "Back" : fmt::format("Back at {}", OneLine(letter));
}

std::string FindWhat() { return "Say what to find: find moon."; }
std::string NotInText(std::string_view wanted) {
  return fmt::format("Not in this text: {}.", OneLine(wanted, 20));
}
std::string NowhereToReturn() { return "Nowhere to return to: nothing was found yet."; }
std::string BackAlready() { return "You are back already."; }
std::string NoLineBehind() { return "This is the last line."; }
std::string NoHeadingBehind() { return "No heading further on."; }
std::string NoParagraphBehind() { return "No paragraph further on."; }
std::string NoLinkBehind() { return "No link further on."; }
std::string NoSuchPage(std::string_view number, std::size_t pages) {
  return pages == 1 ? "There is one page only."
                    : fmt::format("No page {}: say go to 1 to {}.", OneLine(number, 12), pages);
}
std::string NoPlaceHere() { return "The page is empty: nothing to go to."; }

}  // namespace moontrace::say
