#pragma once

#include "textures/fonts/script.h"

namespace moontrace {

/// Slant and width of letters.
struct LetterForm {
  double slant = 0;    ///< from upright, leaning right above zero [rad]
  double stretch = 1;  ///< of widths and advances; heights stay
  bool operator==(const LetterForm&) const = default;
};

/// A script whose letters lean and are wider or narrower: x becomes stretch x + tan(slant) (y -
/// y0), y stays. y0 is the base line of letters that lean right and the top line of those that lean
/// left, so that none between them reaches back over where it starts. Lines stay lines, arcs become
/// parts of ellipses, refitted to arcs within 0.001 em; dots are moved and stay round. Advances and
/// the space are stretched. An upright form of width 1 gives the script unchanged.
///
/// Throws InputError: Braille, whose dots stand at standard distances; a slant beyond 30 degrees, a
/// stretch outside 0.5 to 2.
Script Reshaped(const Script& script, const LetterForm& form);

/// How far that moves what stands on the base line [em].
double FootShift(const LetterForm& form);

}  // namespace moontrace
