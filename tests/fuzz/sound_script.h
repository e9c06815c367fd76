#pragma once

#include <cmath>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "textures/base/error.h"
#include "textures/fonts/script.h"

/// What every reader of foreign letters must keep to, whatever the bytes.
namespace moontrace {

inline void Require(bool holds) {
  if (!holds) std::abort();
}

inline void RequireSound(const std::vector<Stroke>& strokes) {
  for (const Stroke& stroke : strokes) {
    Require(!stroke.pieces.empty());
    Require(stroke.kind != StrokeKind::kDot || stroke.pieces.size() == 1);
    for (const Piece& piece : stroke.pieces) {
      Require(std::isfinite(Length(piece)) && Length(piece) < 1000);
    }
  }
}

inline void RequireSound(const Script& script) {
  Require(!script.glyphs.empty() && !script.grades.empty() && script.space_advance > 0);
  for (const Glyph& glyph : script.glyphs) {
    Require(glyph.advance > 0 && glyph.advance <= 100 && !glyph.strokes.empty());
    RequireSound(glyph.strokes);
  }
  for (const auto& sign : script.signs) Require(script.Find(sign.second) != Script::npos);
  for (const Contraction& contraction : script.contractions) {
    for (const auto& sign : contraction.signs) Require(script.Find(sign) != Script::npos);
  }
}

/// Runs a reader: what it gives is sound, or it refuses with an InputError of one line.
template <class Reader>
void RequireSoundOrRefused(const Reader& read) {
  try {
    RequireSound(read());
  } catch (const InputError& error) {
    Require(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
}

}  // namespace moontrace
