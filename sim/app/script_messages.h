#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "textures/fonts/script.h"
#include "textures/fonts/script_check.h"

/// The sentences of `moontrace script`.
namespace moontrace::say {

std::string NoScriptNamed(std::string_view action);
std::string NotOfThisAction(std::string_view option, std::string_view action);
std::string ScriptCount(std::size_t count);
std::string ScriptLine(std::string_view name, const Script& script);
std::string ScriptUnread(std::string_view name);
std::string ScriptOutcome(const Script& script);
std::string ScriptAuthor(const Script& script);
std::string ScriptLicence(const Script& script);
std::string ScriptSizes(const Script& script);
std::string ScriptCovers(std::string_view characters);
std::string ScriptRules(const Script& script);
std::string ScriptIsOutlines();
std::string CheckOutcome(std::size_t findings, std::size_t glyphs, const CheckSize& size);
std::string FindingLine(const ScriptFinding& finding, const Script& script);
/// `names`: the first signs that have one.
std::string FindingsOfKind(ScriptFinding::Kind kind, std::size_t findings, std::size_t glyphs,
                           const std::vector<std::string>& names);
std::string FindingsSummedUp();
std::string MoreFindings(std::size_t count);
/// `why`: the line that reading it back would say.
std::string NotConverted(std::string_view why);
/// What lies where the font or the rules (`what`) would be written may be somebody's work.
std::string InTheWay(std::string_view path, std::string_view what);
std::string Converted(std::size_t glyphs, std::size_t joined);
std::string TableOutcome(std::size_t shown, std::size_t glyphs);
std::string TableRow(std::size_t row, std::string_view names);
std::string NotAnSvgPath(std::string_view path);

namespace help {
inline constexpr const char* kScriptCommand =
    "lists scripts, says what one holds, checks its strokes, converts it, draws a table";
inline constexpr const char* kScriptAction = "list, info, check, convert or picture.";
inline constexpr const char* kScriptName = "name of a script, path of its file or folder.";
inline constexpr const char* kScriptOnly =
    "only these characters; for scripts of thousands. Default all.";
inline constexpr const char* kScriptSize =
    "check: size of the letters in mm that strokes must be good for. Default the script's own.";
inline constexpr const char* kScriptAll =
    "check: list each finding; else kinds with more than 20 are summed up.";
inline constexpr const char* kScriptTo =
    "convert: write this SVG font, and a TOML file of its rules beside it; where another file lies "
    "in the place of the rules, nothing is written (exit code 4).";
inline constexpr const char* kScriptJoin =
    "convert: make one stroke of strokes that follow each other.";
inline constexpr const char* kScriptPicture = "picture: write this file, .svg, .png or .pdf.";
}  // namespace help

}  // namespace moontrace::say
