#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "textures/field/element.h"
#include "textures/field/texture.h"
#include "textures/fonts/script.h"
#include "textures/typeset/text_page.h"

namespace moontrace {

/// Cross-sections of a style's ridges: rounded by a fifth of their width.
Profile RuleProfile(const TypeStyle& style);
Profile MarginProfile(const TypeStyle& style);
/// Least distance between the rim of a ridge and that of a stroke: a tenth of the size; with groove
/// links, which run there, most of the space between lines [m].
double RuleGap(const TypeStyle& style);

/// Least distance between the rims of one line's rule and the next line's, so that they are felt as
/// two: a rule's width, at least 0.5 mm. Ours [m].
double RulesApart(const TypeStyle& style);

/// The least line pitch at which rules fit between any two lines of these glyphs [m].
double LeastRuledPitch(const std::set<std::size_t>& glyphs, const Script& script,
                       const TypeStyle& style);

/// Throws InputError when a width or height is not finite, below zero, or steeper than 5.
void CheckRules(const TypeStyle& style);

/// The sideways force that turns back a tip pressing on a ridge with `press` [N], without friction:
/// press times the greatest slope. The potential law pushes with N (-grad h, 1), so that a tip at
/// rest on the flank, N = press, needs press * h' along the page; see surface.h.
double TurningForce(const Profile& ridge, double press);

/// The middles of a page's ridges, in P.
struct RaisedLines {
  std::vector<Line> rules;
  std::vector<Piece> margin;  ///< a rectangle with round corners, counter-clockwise
};
/// Rules stand beside the strokes of all lines of one size at one distance, as long as the text
/// area, cut where a guide line passes. Throws InputError when the line pitch or the sheet's margin
/// leaves no room.
RaisedLines RaisedLinesOf(const TextPage& page, const Script& script, const TypeStyle& style);

/// Adds them to the page's tree, as layers of ridges.
void AddRules(const TextPage& page, const Script& script, const TypeStyle& style, Texture& texture);

}  // namespace moontrace
