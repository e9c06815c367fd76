#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "textures/fonts/script.h"

namespace moontrace {

/// Strokes of one character from a KanjiVG file (kanjivg.tagaini.net): a drawing of 109 x 109
/// units, y down, one <path> a stroke. The em is the box: x and y from 0 to 1, the base line its
/// foot. Strokes stand in writing order: by the number at the end of their id ("kvg:04e00-s1"),
/// without ids as in the file. The numbers drawn beside the strokes (<text>) are left out. Curves
/// become arcs within 0.001 em. Throws InputError (file:line:column, cause, cure).
std::vector<Stroke> ParseKanjiVg(std::string_view svg, const std::string& file_name);

/// Whether a folder has files that are named as KanjiVG names them: five hexadecimal digits or
/// more, ".svg".
bool IsKanjiVgFolder(const std::string& folder);

/// A script of the characters in a KanjiVG folder, each one em wide. Only those in `needed` are
/// read; all (at most 20 000) where it is empty. Variants ("04e00-Kaisho.svg") are not read. A
/// "script.toml" in the folder may give title, author, licence and stroke_width_em. Throws
/// InputError: none of the needed characters is there, more than 20 000, a broken file.
Script LoadKanjiVg(const std::string& folder, const std::set<char32_t>& needed);

}  // namespace moontrace
