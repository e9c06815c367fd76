#pragma once

#include <cstddef>
#include <vector>

#include "textures/field/element.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// A stroke that a tip is meant to follow, on the page: what tracing is measured against.
struct IntendedStroke {
  StrokeKind kind = StrokeKind::kStroke;
  std::vector<Piece> spine_P;  ///< centre line [m]; of a fill its centre arc; of a dot the circle's
                               ///< centre, as a Line of length zero
  double width = 0;            ///< of the groove [m]
  std::size_t glyph = 0;       ///< index into the page's glyphs
  Relief relief = Relief::kEngraved;
  double dot_radius = 0;              ///< of a dot: how far its flat floor reaches [m]
  std::vector<Piece> outline_P = {};  ///< of a fill, whose floor within is flat [m]
};

/// The strokes of a page's text in writing order, none of a running head, which is not traced.
std::vector<IntendedStroke> IntendedStrokes(const TextPage& page, const Script& script,
                                            const TypeStyle& style);

/// Length of its centre line [m]; a dot counts as long as it is wide.
double LengthOf(const IntendedStroke& stroke);

}  // namespace moontrace
