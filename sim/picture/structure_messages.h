#pragma once

#include <string>

#include "textures/typeset/typeset.h"

/// Sentences about the form of letters and the structure of a text.
namespace moontrace::say {

/// "Letters lean 15 degrees to the right, 1.2 times as wide."; empty for upright ones.
std::string Form(const LetterForm& form);
/// "Structure: 2 headings, 1 quotation, 3 links; headings 18 mm high."
std::string Structure(const Typeset& set);

/// What a picture shows of it: " Headings are ridges, green."; empty where nothing is special.
std::string HeadingWords(const TypeStyle& style);

namespace help {
inline constexpr const char* kSlant =
    "letters lean by so many degrees, -30 to 30, to the right above 0. Default 0; not Braille.";
inline constexpr const char* kStretch =
    "letters so many times as wide, 0.5 to 2. Default 1; not Braille.";
inline constexpr const char* kStructure =
    "read marks: a line that begins with # is a heading (## and ### too), with > a quotation, "
    "[words](address) a link; behind a backslash they are characters. Default: marks are "
    "characters.";
inline constexpr const char* kHeadingScale =
    "with --structure: headings so many times as large as the text, 1 to 5. Default 1.5.";
inline constexpr const char* kHeadingRelief =
    "with --structure: headings engraved or embossed. Default as the text.";
inline constexpr const char* kStructureTexture =
    "with --structure: yes lays headings, quotations and links on rough paper, each its own. "
    "Default no.";
}  // namespace help

}  // namespace moontrace::say
