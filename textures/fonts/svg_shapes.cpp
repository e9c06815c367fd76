#include "textures/fonts/svg_shapes.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "textures/base/overload.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

constexpr std::size_t kDeepest = 32;  ///< <g> and <use> within each other

StrokeKind KindOf(const Subpath& subpath) {
  if (!subpath.closed) return StrokeKind::kStroke;
  const bool circle = std::visit(
      Overload{[](const Line&) { return false; }, [](const Arc& arc) { return IsWhole(arc); }},
      subpath.pieces.front());
  return circle && subpath.pieces.size() == 1 ? StrokeKind::kDot : StrokeKind::kFill;
}

/// Elements that draw nothing.
bool IsSilent(std::string_view name) {
  return name == "title" || name == "desc" || name == "metadata" || name == "defs" ||
         name == "style";
}

}  // namespace

SvgShapes::SvgShapes(const SvgSource& source, PathLimits& limits)
    : source_(source), limits_(limits) {}

std::vector<Stroke> SvgShapes::Of(pugi::xml_node node) {
  std::vector<Stroke> strokes;
  used_.assign(1, node);
  const pugi::xml_attribute path = node.attribute("d");
  AppendPath(node, path.value(), path, glm::dvec2(0.0, 0.0), strokes);
  AppendChildren(node, glm::dvec2(0.0, 0.0), strokes);
  used_.clear();
  return strokes;
}

void SvgShapes::AppendChildren(pugi::xml_node node, glm::dvec2 moved,
                               std::vector<Stroke>& strokes) {
  for (const pugi::xml_node child : node.children()) {
    if (child.type() != pugi::node_element || IsSilent(child.name())) continue;
    AppendElement(child, moved, strokes);
  }
}

void SvgShapes::Spend(pugi::xml_node node) {
  if (limits_.commands == 0) source_.Fail(node, "too many path commands; simplify the drawing");
  --limits_.commands;
}

void SvgShapes::AppendElement(pugi::xml_node node, glm::dvec2 moved, std::vector<Stroke>& strokes) {
  const std::string_view name = node.name();
  if (node.attribute("transform")) {
    source_.Fail(node, "a transform is not read; apply it in the editor");
  }
  Spend(node);
  if (name == "path") {
    const pugi::xml_attribute path = node.attribute("d");
    AppendPath(node, path.value(), path, moved, strokes);
  } else if (name == "circle") {
    Append(Circle(node), moved, strokes);
  } else if (name == "line") {
    AppendLine(node, moved, strokes);
  } else if (name == "polyline" || name == "polygon") {
    AppendPoints(node, name == "polygon", moved, strokes);
  } else if (name == "use") {
    AppendUse(node, moved, strokes);
  } else if (name == "g") {
    if (used_.size() >= kDeepest) source_.Fail(node, "groups nest too deep; ungroup them");
    used_.push_back(node);
    AppendChildren(node, moved, strokes);
    used_.pop_back();
  } else {
    source_.Fail(node,
                 fmt::format("<{}> in a glyph is not read; convert it to a path in the editor",
                             OneLine(name, 24)));
  }
}

void SvgShapes::AppendUse(pugi::xml_node node, glm::dvec2 moved, std::vector<Stroke>& strokes) {
  if (!ids_known_) {
    source_.root().find_node([this](pugi::xml_node each) {
      if (each.attribute("id")) ids_.emplace(each.attribute("id").value(), each);
      return false;
    });
    ids_known_ = true;
  }
  std::string target = node.attribute("href").value();
  if (target.empty()) target = node.attribute("xlink:href").value();
  const auto found = ids_.find(target.empty() ? target : target.substr(1));
  if (target.empty() || target[0] != '#' || found == ids_.end()) {
    source_.Fail(node, "<use> of '" + OneLine(target, 40) +
                           "', which is no id of this file; draw it in place");
  }
  if (std::find(used_.begin(), used_.end(), found->second) != used_.end()) {
    source_.Fail(node, "<use> of '" + OneLine(target, 40) +
                           "' within itself: a cycle without end; draw it in place");
  }
  if (used_.size() >= kDeepest) source_.Fail(node, "<use> nests too deep; draw it in place");
  moved +=
      glm::dvec2(source_.NumberOf(node, "x").value_or(0), source_.NumberOf(node, "y").value_or(0));
  if (!(std::max(std::abs(moved.x), std::abs(moved.y)) <= limits_.greatest)) {
    source_.Fail(node, "<use> moves beyond 100 em; correct its x and y");
  }
  used_.push_back(found->second);
  if (std::string_view(found->second.name()) == "glyph") {
    const pugi::xml_attribute path = found->second.attribute("d");
    AppendPath(found->second, path.value(), path, moved, strokes);
    AppendChildren(found->second, moved, strokes);
  } else if (std::string_view(found->second.name()) == "g") {
    AppendChildren(found->second, moved, strokes);
  } else {
    AppendElement(found->second, moved, strokes);
  }
  used_.pop_back();
}

void SvgShapes::AppendPath(pugi::xml_node node, const std::string& path, pugi::xml_attribute from,
                           glm::dvec2 moved, std::vector<Stroke>& strokes) {
  try {
    for (const Subpath& subpath : ParseSvgPath(path, limits_)) Append(subpath, moved, strokes);
  } catch (const SvgPathError& error) {
    source_.Fail(node, from, error.offset(), error.what());
  }
}

void SvgShapes::AppendPoints(pugi::xml_node node, bool closed, glm::dvec2 moved,
                             std::vector<Stroke>& strokes) {
  // The points are what follows an M in a path; a letter among them would be a command.
  const pugi::xml_attribute points = node.attribute("points");
  const std::string_view text = points.value();
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c >= 'A' && c != 'e' && c != 'E') source_.Fail(node, points, i, "points hold a letter");
  }
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) return;
  // The M is put before the value, which moves places by one byte: too little to matter.
  AppendPath(node, fmt::format("M{}{}", text, closed ? "Z" : ""), points, moved, strokes);
}

void SvgShapes::AppendLine(pugi::xml_node node, glm::dvec2 moved, std::vector<Stroke>& strokes) {
  const auto at = [&](const char* name) { return source_.NumberOf(node, name).value_or(0); };
  const std::string path =
      fmt::format("M{:.9g} {:.9g}L{:.9g} {:.9g}", at("x1"), at("y1"), at("x2"), at("y2"));
  AppendPath(node, path, pugi::xml_attribute(), moved, strokes);
}

Subpath SvgShapes::Circle(pugi::xml_node node) const {
  const glm::dvec2 center(source_.NumberOf(node, "cx").value_or(0),
                          source_.NumberOf(node, "cy").value_or(0));
  const double radius = source_.NumberOf(node, "r").value_or(0);
  const double reach = std::max(std::abs(center.x), std::abs(center.y)) + radius;
  if (!(radius > 0 && reach <= limits_.greatest)) {
    source_.Fail(node, "a circle without a radius above 0, or beyond 100 em; correct cx, cy, r");
  }
  return CircleSubpath(center, radius);
}

void SvgShapes::Append(const Subpath& subpath, glm::dvec2 moved,
                       std::vector<Stroke>& strokes) const {
  Stroke stroke;
  stroke.kind = KindOf(subpath);
  for (const Piece& piece : subpath.pieces) stroke.pieces.push_back(Placed(piece, 1, moved));
  strokes.push_back(std::move(stroke));
}

}  // namespace moontrace
