#pragma once

#include <set>
#include <string>
#include <vector>

#include "textures/fonts/script.h"

namespace moontrace {

/// Characters that a script of characters may have.
constexpr std::size_t kMostCharacters = 20000;

/// An empty script for Chinese characters: a sign fills its em box, sizes are those of the box,
/// lines have no word spaces (a blank is as wide as a character), strokes are as wide as the
/// densest common characters allow.
Script CharacterScript(const std::string& name);

/// Adds a character that fills its box. The glyph goes by the character itself.
void AddCharacter(char32_t c, std::vector<Stroke> strokes, Script& script);

/// Takes title, author, licence and, if it stands there, stroke_width_em from a TOML file; what
/// `script` has already stays if there is no such file. Throws InputError for a broken one.
void ReadCredits(const std::string& toml_path, Script& script);

/// Throws InputError "place: has none of ..." if the script has no glyph.
void RequireCharacters(const Script& script, const std::set<char32_t>& needed,
                       const std::string& place);

}  // namespace moontrace
