#include "sim/app/script_messages.h"

#include <fmt/core.h>

#include <algorithm>

#include "sim/console/wording.h"
#include "textures/base/text_file.h"
#include "textures/base/units.h"

namespace moontrace::say {

namespace {

using Kind = ScriptFinding::Kind;

std::string Mm(double metres) { return Short(kMillimetres * metres, 2) + " mm"; }
std::string Em(double em) { return Short(em, 3) + " em"; }
std::string Degrees(double angle) { return Short(InDegrees(angle), 0) + " degrees"; }

const char* Name(Kind kind) {
  switch (kind) {
    case Kind::kSplit:
      return "split stroke";
    case Kind::kLift:
      return "needless lift";
    case Kind::kReversed:
      return "reversed stroke";
    case Kind::kOverlap:
      return "overlap";
    case Kind::kTightBend:
      return "bend too tight";
    case Kind::kNarrowGap:
      return "gap too narrow";
    case Kind::kTooMany:
      return "too many strokes";
  }
  return "";
}

std::string Explained(const ScriptFinding& finding) {
  switch (finding.kind) {
    case Kind::kSplit:
      return "the second goes on where the first ends, turn " + Degrees(finding.figure) +
             "; join them";
    case Kind::kLift:
      return "the second starts where the first ends, turn " + Degrees(finding.figure) +
             "; join them";
    case Kind::kReversed:
      return "their ends meet, turn " + Degrees(finding.figure) + "; reverse one and join them";
    case Kind::kOverlap:
      return Mm(finding.figure) + " are travelled twice";
    case Kind::kTightBend:
      return "radius " + Mm(finding.figure) + ", needs " + Mm(finding.needed);
    case Kind::kNarrowGap:
      if (finding.figure < 0) return "grooves run " + Mm(-finding.figure) + " into each other";
      return Mm(finding.figure) + " between the grooves, needs " + Mm(finding.needed);
    case Kind::kTooMany:
      return fmt::format("{} in all, the first {} are looked at", Short(finding.figure, 0),
                         kMostCheckedStrokes);
  }
  return "";
}

}  // namespace

std::string NoScriptNamed(std::string_view action) {
  return fmt::format("script {}: name a script, as in: moontrace script {} moon", action, action);
}

std::string NotOfThisAction(std::string_view option, std::string_view action) {
  return fmt::format("script {}: {} is not for this; leave it out", action, option);
}

std::string ScriptCount(std::size_t count) { return Counted(count, "script.", "scripts."); }

std::string ScriptLine(std::string_view name, const Script& script) {
  return fmt::format("{}: {}, {}, licence {}.", OneLine(name, 40), OneLine(script.title, 60),
                     Counted(script.glyphs.size(), "sign", "signs"), OneLine(script.licence, 80));
}

std::string ScriptUnread(std::string_view name) {
  return fmt::format("{}: cannot be read; see: moontrace script info {}", OneLine(name, 40),
                     OneLine(name, 40));
}

std::string ScriptOutcome(const Script& script) {
  return fmt::format("{}: {}.", OneLine(script.title, 60),
                     Counted(script.glyphs.size(), "sign", "signs"));
}

std::string ScriptAuthor(const Script& script) {
  return "Author: " + OneLine(script.author, 300) + ".";
}

std::string ScriptLicence(const Script& script) {
  return "Licence: " + OneLine(script.licence, 300) + ".";
}

std::string ScriptSizes(const Script& script) {
  double narrow = 1e300, wide = 0;
  for (const Glyph& glyph : script.glyphs) {
    narrow = std::min(narrow, glyph.advance);
    wide = std::max(wide, glyph.advance);
  }
  const std::string signs = wide > narrow ? Em(narrow) + " to " + Em(wide) : Em(wide);
  return fmt::format("Sizes: signs {} wide with their gap, space {}, strokes {}.", signs,
                     Em(script.space_advance), Em(script.stroke_width));
}

std::string ScriptCovers(std::string_view characters) {
  return fmt::format("Writes: {}", characters);
}

std::string ScriptRules(const Script& script) {
  std::string grades;
  for (const double grade : script.grades) {
    grades += fmt::format("{}{}", grades.empty() ? "" : ", ", grade);
  }
  return fmt::format("Rules: {}, {}, grade {}.",
                     Counted(script.contractions.size(), "contraction", "contractions"),
                     script.digits.empty() ? "no numeral sign" : "a numeral sign", grades);
}

std::string ScriptIsOutlines() {
  return "For print, not of strokes: most signs are closed outlines, felt as filled areas. Give a "
         "font whose letters are open paths; in fontforge set Stroked Font before saving.";
}

std::string CheckOutcome(std::size_t findings, std::size_t glyphs, const CheckSize& size) {
  return fmt::format("{} in {}, letters of {}, grooves of {}, a probe of {}.",
                     Counted(findings, "finding", "findings"), Counted(glyphs, "sign", "signs"),
                     Mm(size.size), Mm(size.groove), Mm(size.probe_diameter));
}

std::string FindingLine(const ScriptFinding& finding, const Script& script) {
  const std::string name = OneLine(script.glyphs[finding.glyph].name, 40);
  if (finding.kind == Kind::kTooMany) {
    return fmt::format("{}: {}, {}.", name, Name(finding.kind), Explained(finding));
  }
  const std::string strokes =
      finding.other == finding.stroke
          ? fmt::format("stroke {}", finding.stroke + 1)
          : fmt::format("strokes {} and {}", finding.stroke + 1, finding.other + 1);
  return fmt::format("{}: {}, {}: {}.", name, Name(finding.kind), strokes, Explained(finding));
}

std::string FindingsOfKind(ScriptFinding::Kind kind, std::size_t findings, std::size_t glyphs,
                           const std::vector<std::string>& names) {
  std::string examples;
  for (const std::string& name : names) {
    examples.append(examples.empty() ? "" : ", ").append(OneLine(name, 40));
  }
  return fmt::format("{}: {} in {}{}{}.", Name(kind), findings, Counted(glyphs, "sign", "signs"),
                     glyphs > names.size() ? ", such as " : ": ", examples);
}

std::string FindingsSummedUp() {
  return "Kinds with more than 20 findings are summed up; --all lists each.";
}

std::string MoreFindings(std::size_t count) {
  return fmt::format("And {}; take fewer signs with --only.",
                     Counted(count, "more finding", "more findings"));
}

std::string NotConverted(std::string_view why) {
  return fmt::format(
      "script convert: not written, it could not be read back ({}): take other or fewer signs "
      "with --only",
      why);
}

std::string InTheWay(std::string_view path, std::string_view what) {
  return fmt::format(
      "nothing converted: another file, or one changed by hand, lies where the {} would go; give "
      "--to another name, or remove it: {}",
      what, OneLine(path, 300));
}

std::string Converted(std::size_t glyphs, std::size_t joined) {
  const std::string signs = Counted(glyphs, "sign", "signs");
  if (joined == 0) return fmt::format("Converted {}; the font and its rules are in:", signs);
  return fmt::format("Converted {}, {} joined to the one before; the font and its rules are in:",
                     signs, Counted(joined, "stroke", "strokes"));
}

std::string TableOutcome(std::size_t shown, std::size_t glyphs) {
  if (shown == glyphs) return fmt::format("{} drawn.", Counted(glyphs, "sign", "signs"));
  return fmt::format("{} of {} signs drawn; name others with --only.", shown, glyphs);
}

std::string TableRow(std::size_t row, std::string_view names) {
  return fmt::format("Row {}: {}", row + 1, names);
}

std::string NotAnSvgPath(std::string_view path) {
  return fmt::format("--to is '{}'; give a path that ends in .svg", OneLine(path, 60));
}

}  // namespace moontrace::say
