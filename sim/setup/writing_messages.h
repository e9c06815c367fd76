#pragma once

#include <string>
#include <string_view>

#include "textures/typeset/back_translate.h"
#include "textures/typeset/typeset.h"

/// Sentences about how text is written: fallbacks, taught signs, reading back, directions of lines.
namespace moontrace::say {

/// A character that is written by another script, by sound or by name.
std::string WrittenBy(const Replacement& replacement, std::string_view was, std::string_view became,
                      std::string_view where);
std::string NotTaught(std::string_view was, std::string_view where);
std::string ReadBackOutcome(const BackTranslation& back);
std::string ReadBackLine(std::string_view line);
std::string ReadOtherwise(std::string_view was, std::string_view became);
std::string MoreWords(std::size_t count);
/// Of the words that read otherwise, those that no reader can tell apart.
std::string WrittenAlike(std::size_t count);

namespace help {
inline constexpr const char* kTable =
    "Braille: a table of liblouis, like de-g2.ctb, in place of the grade's.";
inline constexpr const char* kFallbackScript =
    "script whose signs stand for characters that --script lacks, before they are spelled or "
    "named.";
inline constexpr const char* kOnly =
    "signs taught so far, like abc+th: letters, then names of signs; contractions with others are "
    "spelled out, letters not among them left out and told.";
inline constexpr const char* kPunctuation =
    "today or older: Moon's older rules put the question mark before its question, which ends in a "
    "short stop, as colons and abbreviations do. Default today.";
inline constexpr const char* kLines =
    "left-to-right, right-to-left, alternate (old Moon, with guide lines) or vertical (downwards, "
    "the next to the left). Default left-to-right.";
inline constexpr const char* kHyphenate =
    "break words at a line's end, by the patterns of a language: en_US. Every broken word then "
    "shows it by a hyphen, on lines that hold two letters beside it. Default: only a word longer "
    "than a line is broken, without a mark.";
inline constexpr const char* kRunningHead = "stands on the first line of each page.";
inline constexpr const char* kPageNumbers = "at the end of each page's first line.";
inline constexpr const char* kParagraphGap =
    "in place of the empty line at blank lines of the text, in mm; along the line if lines "
    "alternate.";
inline constexpr const char* kReadBack =
    "what the signs say by the script's rules, and whether it is the text.";
}  // namespace help

}  // namespace moontrace::say
