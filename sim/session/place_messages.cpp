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
  if (pages == 1) return "There is one page only.";
  if (number.empty()) return fmt::format("Say which page: go to 1 to {}.", pages);
  return fmt::format("No page {}: say go to 1 to {}.", OneLine(number, 12), pages);
}
std::string NoPlaceHere() { return "The page is empty: nothing to go to."; }

namespace {

/// "plate, LIFT"; a text that its label is called by, once.
std::string Named(std::string_view name, std::string_view text) {
  std::string shown = OneLine(name, 24);
  if (text.empty() || LowerCase(name) == LowerCase(text)) return shown;
  return fmt::format("{}, {}", shown, OneLine(text, 24));
}

}  // namespace

std::string NoLabels() { return "No labels here: they are of a model, loop --model FILE."; }
std::string OneLabel() { return "This model has one label only."; }
std::string LabelsAre(std::size_t count) {
  return count == 1 ? "1 label."
                    : fmt::format("{} labels. Say next label, or find and a name.", count);
}
std::string LabelIs(std::string_view name, std::string_view text, std::string_view face,
                    bool here) {
  std::string said = Named(name, text);
  if (!face.empty()) said += fmt::format(", {}", face);
  return said + (here ? ": you are here." : ".");
}
std::string LabelStays(std::string_view why) {
  return fmt::format("The label stays as it is: {}.", OneLine(why, 200));
}
std::string WayToLabel(std::string_view label, glm::dvec3 way_P) {
  while (label.ends_with('.')) label.remove_suffix(1);
  const std::string along = Way(glm::dvec2(way_P));
  if (!(way_P.z > 0)) return fmt::format("{}: {}.", label, along);
  return fmt::format("{}: first {} mm out from its face, then {}.", label,
                     Short(kMillimetres * way_P.z, 1), along);
}
std::string Touched(std::string_view geom, std::string_view text) {
  return fmt::format("Touched: {}.", Named(geom, text));
}
std::string Pressed(std::string_view geom) {
  return fmt::format("Pressed: {}.", OneLine(geom, 24));
}

}  // namespace moontrace::say
