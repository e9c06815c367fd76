#pragma once

#include <vector>

#include "sim/picture/drawing.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// Colours of the Okabe-Ito set, which colour-blind eyes can distinguish, and plain greys.
namespace palette {
inline constexpr Color kInk{0.10, 0.10, 0.10};
inline constexpr Color kGroove{0.55, 0.55, 0.52};
inline constexpr Color kPaperEdge{0.55, 0.55, 0.55};
inline constexpr Color kRough{0.90, 0.90, 0.87};
inline constexpr Color kRidge{0.00, 0.62, 0.45};
inline constexpr Color kLink{0.38, 0.52, 0.72};
inline constexpr Color kTip{0.00, 0.20, 0.45};
inline constexpr Color kAway{0.84, 0.37, 0.00};
}  // namespace palette

/// The strokes of a page as the fingers find them: grooves or ridges in their true width with round
/// ends, fills filled; headings of another relief than the text in green. `from_P` [m] is where the
/// drawing's origin lies on the page.
std::vector<Mark> MoonMarks(const TextPage& page, const Script& script, const TypeStyle& style,
                            glm::dvec2 from_P, Color color);

/// The same strokes as dashed centre lines: where grooves would be on a blank page.
std::vector<Mark> CentreLineMarks(const TextPage& page, const Script& script,
                                  const TypeStyle& style, glm::dvec2 from_P, Color color);

/// Box around the page's strokes, grooves' width included [m]; holds the origin only if nothing is
/// there.
Box InkBounds(const TextPage& page, const Script& script, const TypeStyle& style);

}  // namespace moontrace
