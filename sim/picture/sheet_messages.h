#pragma once

#include <cstddef>
#include <string>

#include "textures/typeset/rules.h"
#include "textures/typeset/typeset.h"

/// Sentences about the sheet: line rules, raised margin, paper texture.
namespace moontrace::say {

inline constexpr const char* kTextureWords = "none, sine, grid, noise or a .pgm file";

/// One line each.
std::string Rules(const TypeStyle& style, std::size_t count);
std::string RaisedMargin(const TypeStyle& style);
std::string SheetTexture(const TypeStyle& style);
/// What a ridge does to a tip: "A rule turns the tip back up to ...".
std::string TurnsBack(const char* what, const Profile& ridge);
/// How a picture shows the paper's texture.
enum class PaperDrawn { kShaded, kTooFine, kLeftOut };
/// All of that on one line, for a picture; empty if the sheet is plain.
std::string SheetWords(const TypeStyle& style, PaperDrawn drawn);

namespace help {
inline constexpr const char* kRules =
    "a raised rule above and below each line of text. Default off.";
inline constexpr const char* kRuleWidth = "width of a rule in mm. Default a tenth of the size.";
inline constexpr const char* kRuleHeight =
    "height of a rule in mm. Default a quarter of its width.";
inline constexpr const char* kRaisedMargin = "a raised ridge round the text area. Default off.";
inline constexpr const char* kRaisedMarginWidth =
    "width of that ridge in mm. Default a tenth of the size.";
inline constexpr const char* kRaisedMarginHeight =
    "height of that ridge in mm. Default a quarter of its width.";
inline constexpr const char* kTexture =
    "roughness of the whole sheet: none, sine (parallel waves), grid (waves both ways), noise "
    "(hills anyhow), or the path of a grey picture (.pgm), white high. Default none.";
inline constexpr const char* kTextureAmplitude = "how far it rises and falls in mm. Default 0.03.";
inline constexpr const char* kTextureWavelength =
    "from crest to crest in mm; of a picture the width of a tile, repeated. Default 2; a picture "
    "is stretched over the sheet.";
inline constexpr const char* kTextureAngle =
    "direction across the waves of sine and grid, in degrees from the lines of text. Default 0.";
}  // namespace help

}  // namespace moontrace::say
