// Any bytes as a Hershey font: read whole and sound, or refused with an InputError of one line.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "textures/error.h"
#include "textures/hershey.h"

namespace {

using namespace moontrace;

void Require(bool holds) {
  if (!holds) std::abort();
}

[[maybe_unused]] void CheckStrokes(const std::vector<Stroke>& strokes) {
  for (const Stroke& stroke : strokes) {
    Require(!stroke.pieces.empty());
    for (const Piece& piece : stroke.pieces) {
      Require(std::isfinite(Length(piece)) && Length(piece) < 1000);
    }
  }
}

[[maybe_unused]] void CheckGlyphs(const Script& script) {
  Require(!script.glyphs.empty() && !script.grades.empty() && script.space_advance > 0);
  for (const Glyph& glyph : script.glyphs) {
    Require(glyph.advance > 0 && glyph.advance <= 100 && !glyph.strokes.empty());
    CheckStrokes(glyph.strokes);
  }
  for (const auto& sign : script.signs) Require(script.Find(sign.second) != Script::npos);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    CheckGlyphs(ParseHershey(bytes, "a", "a.jhf"));
  } catch (const InputError& error) {
    Require(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
