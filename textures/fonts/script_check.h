#pragma once

#include <cstddef>
#include <vector>

#include "textures/fonts/script.h"

namespace moontrace {

/// Something about a glyph's strokes that makes it harder to trace than it need be.
struct ScriptFinding {
  enum class Kind {
    kSplit,     ///< one stroke ends where another goes on in its direction: one cut in two
    kLift,      ///< a stroke starts where the one before ends, at a corner: the pen could stay down
    kReversed,  ///< two strokes that would be one if either were reversed
    kOverlap,   ///< one stroke runs along another, or back along itself
    kTightBend,  ///< a bend narrower than the groove or the probe
    kNarrowGap,  ///< strokes pass so near that the probe feels no surface between their grooves
    kTooMany     ///< more strokes than are looked at
  };
  Kind kind = Kind::kSplit;
  std::size_t glyph = 0;   ///< index into Script::glyphs
  std::size_t stroke = 0;  ///< index into Glyph::strokes
  std::size_t other = 0;   ///< the other stroke; the same for a stroke with itself
  /// kTooMany: how many there are. kSplit, kLift, kReversed: the turn where they meet [rad];
  /// kOverlap: the length [m]; kTightBend: the radius of the centre line [m]; kNarrowGap: the
  /// surface left between the grooves [m], below zero where they run into each other.
  double figure = 0;
  double needed = 0;  ///< kTightBend, kNarrowGap: the least that is good [m]
};

/// At what size strokes are felt, and with what. Lengths in metres.
struct CheckSize {
  double size = 0.012;             ///< base line to top line
  double groove = 0.0014;          ///< width w
  double probe_diameter = 0.0012;  ///< of the proxy's ball in models/proxy.xml
};

/// Strokes of a sign that are looked at: more than any character has.
constexpr std::size_t kMostCheckedStrokes = 256;

/// Findings about one glyph of a script, by its index. Ends meet within 0.01 em; what comes within
/// half a groove of a stroke has joined it, and is an overlap if it runs along. A bend needs a
/// radius of w/2 (the inner rim shrinks to a point there) and of the probe's; only bends of 90
/// degrees and more count, since a corner is none. Between two grooves that pass each other the
/// surface must be as wide as the probe. Chinese characters and kana (U+2E80 and above) lift the
/// pen by their own rules, so kSplit, kLift and kReversed are not looked for in them. Only the
/// first kMostCheckedStrokes are looked at; kTooMany says where there are more.
///
/// Pure; the time grows with the square of the glyph's samples: 0.01 em apart, but some 2500 at
/// most (of many short pieces not every end is one).
std::vector<ScriptFinding> CheckGlyph(const Script& script, std::size_t glyph,
                                      const CheckSize& size);

/// Whether most glyphs are closed outlines: a font for print, whose letters would be filled areas.
bool IsOutlineFont(const Script& script);

}  // namespace moontrace
