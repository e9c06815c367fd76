#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lessons/measure/intended_strokes.h"
#include "textures/field/element.h"
#include "textures/field/field.h"
#include "textures/script/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// A page as the viewer shows it; never changed once it is shown, shared by threads.
struct ViewPage {
  std::uint32_t number = 0;  ///< LoopSnapshot::page
  TextureField field;
  Box sheet_P;       ///< the paper [m]
  double width = 0;  ///< of a groove [m]
  struct Letter {
    Box box_P;          ///< its em box [m]
    std::string print;  ///< the characters it stands for; empty: none
  };
  std::vector<Letter> letters;  ///< one a glyph of the page, in its order
  /// In writing order; IntendedStroke::glyph is an index into `letters`. None on a blank page.
  std::vector<IntendedStroke> strokes;
};

/// `source`: the text that was set. `blank`: paper without grooves.
std::shared_ptr<const ViewPage> MakeViewPage(const TextPage& page, const PageSpec& sheet,
                                             const Script& script, const TypeStyle& style,
                                             std::string_view source, bool blank,
                                             std::uint32_t number);

}  // namespace moontrace
