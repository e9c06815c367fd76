#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <map>
#include <string>
#include <vector>

#include "textures/fonts/script.h"
#include "textures/fonts/svg_path.h"
#include "textures/fonts/svg_source.h"

namespace moontrace {

/// What is drawn below a node of an SVG document, as strokes in the document's order and units.
///
/// Read are the node's own `d`, <path d>, <circle cx cy r>, <line>, <polyline>, <polygon> and,
/// within <g> and <use href x y> of an id in the same document, the same again. An open subpath is
/// a stroke, a closed one a filled area, a closed circle a dot. A cycle of <use> is refused, so is
/// anything else that would be drawn, and every transform.
class SvgShapes {
 public:
  /// Keeps references to both. `limits` counts down from node to node.
  SvgShapes(const SvgSource& source, PathLimits& limits);

  /// Throws InputError (file:line:column, cause, cure).
  std::vector<Stroke> Of(pugi::xml_node node);

 private:
  void AppendChildren(pugi::xml_node node, glm::dvec2 moved, std::vector<Stroke>& strokes);
  void AppendElement(pugi::xml_node node, glm::dvec2 moved, std::vector<Stroke>& strokes);
  void AppendUse(pugi::xml_node node, glm::dvec2 moved, std::vector<Stroke>& strokes);
  void AppendPath(pugi::xml_node node, const std::string& path, pugi::xml_attribute from,
                  glm::dvec2 moved, std::vector<Stroke>& strokes);
  void AppendPoints(pugi::xml_node node, bool closed, glm::dvec2 moved,
                    std::vector<Stroke>& strokes);
  void AppendLine(pugi::xml_node node, glm::dvec2 moved, std::vector<Stroke>& strokes);
  Subpath Circle(pugi::xml_node node) const;
  void Append(const Subpath& subpath, glm::dvec2 moved, std::vector<Stroke>& strokes) const;
  void Spend(pugi::xml_node node);

  const SvgSource& source_;
  PathLimits& limits_;
  bool ids_known_ = false;
  std::map<std::string, pugi::xml_node> ids_;
  std::vector<pugi::xml_node> used_;  ///< what is being read through <use>, outermost first
};

}  // namespace moontrace
