// Any bytes as text, on any page: set, or refused with an InputError, never anything else. The
// first four bytes choose script, grade, relief, direction of lines, taught signs, size, page and
// whether marks of structure are read and Moon's older punctuation is used.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "tests/textures/small_script.h"
#include "textures/base/error.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/glyph_group.h"
#include "textures/typeset/back_translate.h"
#include "textures/typeset/layout.h"
#include "textures/typeset/taught.h"
#include "textures/typeset/typeset.h"

namespace {

using namespace moontrace;

void Require(bool holds) {
  if (!holds) std::abort();
}

void CheckPages(const Typeset& set, std::string_view text, const Script& script) {
  Require(!set.pages.empty());
  Require(set.folded.size() <= set.folded_count && set.missing.size() <= set.missing_count);
  std::size_t end = 0, word = 0;
  for (const TextPage& page : set.pages) {
    Require(!page.glyphs.empty());
    for (const PlacedGlyph& placed : page.glyphs) {
      Require(placed.glyph < script.glyphs.size() && placed.line < page.lines);
      Require(end <= placed.source_begin && placed.source_begin <= placed.source_end);
      Require(placed.source_end <= text.size() && word <= placed.word);
      end = placed.source_end;
      word = placed.word;
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Script moon = FindScript("moon");
  static const Script small = SmallScript();
  if (size < 4) return 0;
  Script script = data[0] & 1 ? moon : small;
  const Relief relief = data[0] & 2 ? Relief::kEngraved : Relief::kEmbossed;
  TypeStyle style = DefaultStyle(0.001 + 0.0002 * data[1], relief, script);
  style.grade = data[0] & 4 ? 1 : 0.5;
  if (data[0] & 8) style.h_form = "arc";
  style.lines = static_cast<LineDirection>((data[0] >> 4) & 3);
  if (style.lines == LineDirection::kAlternate) AddGuides(script, style);
  if (data[0] & 64) style.paragraph_gap = 0.001 * data[1];
  if (data[0] & 128) style.only = TaughtSigns("abcdehnt+and", script);
  style.structure.read = data[3] & 1;
  style.structure.heading_scale = 1 + 0.01 * data[2];
  if (data[3] & 2) style.structure.heading_relief = Relief::kEmbossed;
  style.structure.texture = data[3] & 4;
  style.older_punctuation = (data[3] & 8) && (data[0] & 1);  // of Moon alone
  const PageSpec page{"custom", 0.021 + 0.001 * data[2], 0.021 + 0.001 * data[3], 0.010};
  const std::string_view text(reinterpret_cast<const char*>(data) + 4, size - 4);
  try {
    const Typeset set = SetText(text, script, style, page);
    CheckPages(set, text, script);
    BuildTexture(set.pages.front(), script, style);
    const BackTranslation back = TranslateBack(text, script, style);
    Require(back.differ.size() <= back.differ_count && back.alike_count <= back.differ_count);
  } catch (const InputError&) {
  }
  return 0;
}
