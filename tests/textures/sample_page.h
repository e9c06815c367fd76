#pragma once

#include <string>

#include "textures/fonts/script.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/glyph_group.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// A page of real text, as the program builds it.
struct SamplePage {
  Script script;
  Typeset typeset;
  Texture texture;
};

inline SamplePage MakePage(const std::string& text, double size, Relief relief,
                           const std::string& page = "a4") {
  SamplePage sample;
  sample.script = FindScript("moon");
  sample.typeset =
      SetText(text, sample.script, DefaultStyle(size, relief, sample.script), FindPage(page));
  sample.texture = BuildTexture(sample.typeset.pages.front(), sample.script, sample.typeset.style);
  return sample;
}

inline const char* const kPangram =
    "Sphinx of black quartz, judge my vow! 1984 (30-27) \"jackdaws\" love 56 big things?";

}  // namespace moontrace
