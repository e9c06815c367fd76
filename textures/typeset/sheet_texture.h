#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "textures/field/paper.h"
#include "textures/field/texture.h"
#include "textures/typeset/text_page.h"

namespace moontrace {

/// Whether a word names a sheet's texture: "none", "sine", "grid", "noise", or a path that ends in
/// .pgm.
bool IsTextureWord(std::string_view word);

/// Reads the file again that a style names, as when it comes out of a record. Throws InputError.
void ReadHeights(SheetTexture& texture);

/// Throws InputError as Check in paper.h does, and when texture and strokes add up to a slope above
/// 5.
void CheckSheetTexture(const TypeStyle& style, const Box& sheet_P);

/// Adds the sheet's texture to its tree.
void AddSheetTexture(const TextPage& page, const TypeStyle& style, Texture& texture);

}  // namespace moontrace
