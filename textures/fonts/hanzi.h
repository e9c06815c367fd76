#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "textures/fonts/script.h"

namespace moontrace {

/// Strokes of one character from the medians of Make Me a Hanzi or hanzi-writer-data: a JSON object
/// whose "medians" are polylines in writing order, in a box of 1024 units, x from 0, y up from -124
/// to 900. The em is the box, its foot the base line. Strokes are `RoundedPolyline`s within
/// kPolylineTolerance. `where` ("file:line") stands in messages. Throws InputError (where, cause,
/// cure): broken JSON, no medians, a number beyond ten boxes, more than 256 strokes or 4096 points.
std::vector<Stroke> ParseMedians(std::string_view json, const std::string& where);

/// A script from Make Me a Hanzi's graphics.txt: one such object a line, with its "character". Only
/// lines of characters in `needed` are parsed, all (at most 20 000) where it is empty. The file is
/// read line by line and never held. A TOML file of the same name may give title, author, licence
/// and stroke_width_em. Throws InputError (file:line): a line over 1 MB, a file over 256 MB, not
/// UTF-8, broken JSON, none of the needed characters.
Script LoadHanziFile(const std::string& path, const std::set<char32_t>& needed);

/// A script from a folder of hanzi-writer-data: one object a file, named by its character
/// ("一.json"). A "script.toml" in the folder may give title, author, licence and stroke_width_em.
Script LoadHanziFolder(const std::string& folder, const std::set<char32_t>& needed);

/// Whether a folder has a file named as those are.
bool IsHanziFolder(const std::string& folder);

}  // namespace moontrace
