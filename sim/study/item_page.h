#pragma once

#include <string>
#include <vector>

#include "lessons/measure/intended_strokes.h"
#include "textures/field/field.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// A page with one line of text for a learner's hand.
struct ItemPage {
  TypeStyle style;
  TextPage page;
  TextureField field;
  std::vector<IntendedStroke> strokes;
  double space = 0;  ///< advance of a space [em]
  /// The box that a hand explores: where any sign of the script could have strokes. The same for
  /// every letter of a size.
  Box box_P;
};

/// How deep the grooves of an item's page are.
struct ItemRelief {
  double grade = 1;  ///< of the script
  /// Share of the usual depth: shallow grooves can be felt but do not guide the hand. 0: blank.
  double depth_share = 1;
};

/// Throws as SetText.
ItemPage SetItem(const std::string& text, const Script& script, double size,
                 const ItemRelief& relief = {});

}  // namespace moontrace
