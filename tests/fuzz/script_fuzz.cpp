// Any bytes as a script: the font up to the first zero byte, its rules behind it. Read whole and
// sound, or refused with an InputError of one line; never anything else.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "textures/error.h"
#include "textures/script.h"

namespace {

using namespace moontrace;

void Require(bool holds) {
  if (!holds) std::abort();
}

void CheckScript(const Script& script) {
  Require(!script.glyphs.empty() && !script.grades.empty());
  for (const Glyph& glyph : script.glyphs) {
    Require(glyph.advance > 0 && glyph.advance <= 100 && !glyph.strokes.empty());
    for (const Stroke& stroke : glyph.strokes) {
      Require(!stroke.pieces.empty());
      for (const Piece& piece : stroke.pieces) Require(std::isfinite(Length(piece)));
      Require(stroke.kind != StrokeKind::kDot || stroke.pieces.size() == 1);
    }
  }
  for (const auto& [character, glyph] : script.signs) Require(script.Find(glyph) != Script::npos);
  for (const Contraction& contraction : script.contractions) {
    for (const auto& sign : contraction.signs) Require(script.Find(sign) != Script::npos);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t zero = bytes.find('\0');
  const std::string_view rules = zero == std::string_view::npos ? "" : bytes.substr(zero + 1);
  try {
    CheckScript(ParseScript(bytes.substr(0, zero), "a.svg", rules, "a.toml"));
  } catch (const InputError& error) {
    Require(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
