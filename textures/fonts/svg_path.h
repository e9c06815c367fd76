#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "textures/field/element.h"

namespace moontrace {

/// One subpath of an SVG path, in the path's own units.
struct Subpath {
  std::vector<Piece> pieces;  ///< each starts where the one before ends
  bool closed = false;        ///< ended by Z; the closing line is among the pieces
};

/// What a path may cost and how closely curves are followed, in the path's own units.
struct PathLimits {
  double tolerance = 1;           ///< greatest distance between a curve and its arcs, > 0
  double greatest = 100000;       ///< greatest magnitude of a coordinate, or of a radius once grown
  std::size_t commands = 100000;  ///< still allowed; counted down from path to path
  std::size_t pieces = 200000;    ///< likewise, after curves became arcs
};

/// A broken path: what is wrong and how to mend it, and the byte in the path where it shows.
class SvgPathError : public std::runtime_error {
 public:
  SvgPathError(std::size_t offset, const std::string& what)
      : std::runtime_error(what), offset_(offset) {}
  std::size_t offset() const noexcept { return offset_; }

 private:
  std::size_t offset_;
};

/// Reads an SVG 1.1 path (section 8.3 of that standard): M L H V A Z exact, circular arcs as arcs,
/// C S Q T and elliptical arcs refitted by arcs (`FitArcs`). Pieces without length and subpaths
/// without pieces are dropped; neighbours on one line or circle are joined (`MergePieces`). An
/// empty path has no subpaths. Throws SvgPathError: unknown command, a number missing, not finite
/// or beyond the limits, a path that does not start with M.
std::vector<Subpath> ParseSvgPath(std::string_view path, PathLimits& limits);

/// Reads the number that starts at `offset` and moves `offset` behind it; nothing when there is
/// none or it does not fit a double. Never reads "inf" or "nan", heeds no locale.
std::optional<double> ReadSvgNumber(std::string_view text, std::size_t& offset);

/// The circle as a closed subpath of one arc, from the right, counter-clockwise.
Subpath CircleSubpath(glm::dvec2 center, double radius);

}  // namespace moontrace
