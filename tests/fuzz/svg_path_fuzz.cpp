// Any bytes as an SVG path: joined, finite pieces of some length, or an SvgPathError at a place
// within the path; never anything else.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <string_view>

#include "textures/fonts/svg_path.h"

namespace {

using namespace moontrace;

void Require(bool holds) {
  if (!holds) std::abort();
}

void CheckSubpath(const Subpath& subpath, const PathLimits& limits) {
  Require(!subpath.pieces.empty());
  // Arcs grown to span their chord and curves reach a little beyond the points that are bounded.
  const double reach = 10 * limits.greatest;
  for (std::size_t i = 0; i < subpath.pieces.size(); ++i) {
    const glm::dvec2 start = StartOf(subpath.pieces[i]), end = EndOf(subpath.pieces[i]);
    Require(std::isfinite(Length(subpath.pieces[i])));
    Require(std::abs(start.x) < reach && std::abs(start.y) < reach);
    if (i + 1 < subpath.pieces.size()) {
      Require(glm::length(end - StartOf(subpath.pieces[i + 1])) < limits.tolerance);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view path(reinterpret_cast<const char*>(data), size);
  PathLimits limits;
  try {
    for (const Subpath& subpath : ParseSvgPath(path, limits)) CheckSubpath(subpath, limits);
  } catch (const SvgPathError& error) {
    Require(error.offset() <= size);
    Require(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
