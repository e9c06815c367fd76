#include "sim/app/commands.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <vector>

#include "sim/app/messages.h"
#include "sim/app/script_findings.h"
#include "sim/app/script_messages.h"
#include "sim/picture/picture_file.h"
#include "sim/picture/script_table.h"
#include "sim/setup/help.h"
#include "sim/setup/setup_messages.h"
#include "sim/setup/typeset_report.h"
#include "textures/base/error.h"
#include "textures/base/nearest_word.h"
#include "textures/base/output_file.h"
#include "textures/base/text_file.h"
#include "textures/base/units.h"
#include "textures/base/utf8.h"
#include "textures/fonts/script_check.h"
#include "textures/fonts/script_library.h"
#include "textures/fonts/script_writer.h"
#include "textures/fonts/svg_font_writer.h"
#include "textures/typeset/fold.h"

namespace moontrace {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostOfAKindSaid = 20;
constexpr std::size_t kMostFindings = 500000;  // some 100 MB of JSON
constexpr std::size_t kMostCharactersSaid = 400;
constexpr double kJoinWithin = 0.01;  // [em], as the checker takes ends to meet

int List(const ScriptOptions& options, Console& console) {
  const std::vector<ScriptEntry> entries = ListScripts();
  Json list = Json::array();
  if (!options.output.json) console.Result(say::ScriptCount(entries.size()));
  for (const ScriptEntry& entry : entries) {
    console.CheckStop();
    Json item{{"name", entry.name}, {"path", entry.path}};
    try {
      const Script script = LoadScriptFile(entry.path, "");
      console.Result(say::ScriptLine(entry.name, script));
      item["title"] = script.title;
      item["author"] = script.author;
      item["licence"] = script.licence;
      item["glyphs"] = script.glyphs.size();
    } catch (const InputError& error) {
      console.Result(say::ScriptUnread(entry.name));
      item["error"] = error.what();
    }
    list.push_back(std::move(item));
  }
  if (options.output.json) console.Json(Dump(Json{{"scripts", std::move(list)}}));
  return exit_code::kGood;
}

/// The characters that have a sign, parted by blanks, a few hundred at most, then "...".
std::string Covered(const Script& script) {
  std::string characters;
  std::size_t count = 0;
  for (const auto& sign : script.signs) {
    if (++count > kMostCharactersSaid) return characters + " ...";
    if (count > 1) characters += ' ';
    characters += Shown(ToUtf8(sign.first));
  }
  if (!script.digits.empty()) characters += " 0 to 9 behind the numeral sign";
  return characters;
}

int Info(const ScriptOptions& options, const Script& script, Console& console) {
  if (options.output.json) {
    std::string characters;
    for (const auto& sign : script.signs) characters += ToUtf8(sign.first);
    Json names = Json::array();
    for (const Glyph& glyph : script.glyphs) names.push_back(glyph.name);
    console.Json(Dump(Json{{"name", script.name},
                           {"title", script.title},
                           {"author", script.author},
                           {"licence", script.licence},
                           {"glyphs", std::move(names)},
                           {"characters", characters},
                           {"stroke_width_em", script.stroke_width},
                           {"space_advance_em", script.space_advance},
                           {"grades", script.grades},
                           {"contractions", script.contractions.size()},
                           {"outlines", IsOutlineFont(script)},
                           {"remarks", script.remarks}}));
    return exit_code::kGood;
  }
  console.Result(say::ScriptOutcome(script));
  console.Result(say::ScriptAuthor(script));
  console.Result(say::ScriptLicence(script));
  console.Result(say::ScriptSizes(script));
  console.Result(say::ScriptRules(script));
  console.Result(say::ScriptCovers(Covered(script)));
  if (IsOutlineFont(script)) console.Result(say::ScriptIsOutlines());
  return exit_code::kGood;
}

std::string_view KeyOf(ScriptFinding::Kind kind) {
  switch (kind) {
    case ScriptFinding::Kind::kSplit:
      return "split";
    case ScriptFinding::Kind::kLift:
      return "lift";
    case ScriptFinding::Kind::kReversed:
      return "reversed";
    case ScriptFinding::Kind::kOverlap:
      return "overlap";
    case ScriptFinding::Kind::kTightBend:
      return "tight-bend";
    case ScriptFinding::Kind::kNarrowGap:
      return "narrow-gap";
    case ScriptFinding::Kind::kTooMany:
      return "too-many-strokes";
  }
  return {};
}

Json FindingJson(const ScriptFinding& finding, const Script& script) {
  const bool turn = finding.kind <= ScriptFinding::Kind::kReversed;
  Json json{{"glyph", script.glyphs[finding.glyph].name}, {"kind", KeyOf(finding.kind)}};
  if (finding.kind == ScriptFinding::Kind::kTooMany) {
    json["count"] = finding.figure;
    return json;
  }
  json["strokes"] = {finding.stroke + 1, finding.other + 1};
  json[turn ? "turn_rad" : "figure_mm"] = turn ? finding.figure : kMillimetres * finding.figure;
  if (finding.needed > 0) json["needed_mm"] = kMillimetres * finding.needed;
  return json;
}

/// All kinds, in their order.
std::vector<ScriptFinding::Kind> Kinds() {
  std::vector<ScriptFinding::Kind> kinds;
  for (std::size_t i = 0; i < FindingTally::kKinds; ++i) {
    kinds.push_back(static_cast<ScriptFinding::Kind>(i));
  }
  return kinds;
}

/// The findings are written one by one: as one tree they would take ten times the memory.
void WriteFindings(const FindingTally& tally, const Script& script, Json head, Console& console) {
  head["counts"] = Json::object();
  for (const ScriptFinding::Kind kind : Kinds()) {
    if (tally.of(kind).findings > 0) head["counts"][KeyOf(kind)] = tally.of(kind).findings;
  }
  head["left_out"] = tally.total() - tally.kept().size();
  std::string text = Dump(head);
  text.pop_back();  // the closing brace
  text += ",\"findings\":[";
  for (const ScriptFinding& finding : tally.kept()) {
    if (text.back() != '[') text += ',';
    text += Dump(FindingJson(finding, script));
  }
  console.Json(text + "]}");
}

/// One line a finding, or a kind where one has too many.
void SayFindings(const FindingTally& tally, const Script& script, Console& console) {
  bool summed = false;
  for (const ScriptFinding::Kind kind : Kinds()) {
    const FindingTally::OfKind& of = tally.of(kind);
    if (tally.Keeps(kind)) continue;
    std::vector<std::string> names;
    for (const std::size_t glyph : of.examples) names.push_back(script.glyphs[glyph].name);
    console.Result(say::FindingsOfKind(kind, of.findings, of.glyphs, names));
    summed = true;
  }
  std::size_t said = 0;
  for (const ScriptFinding& finding : tally.kept()) {
    if (++said % 1000 == 0) console.CheckStop();
    if (tally.Keeps(finding.kind)) console.Result(say::FindingLine(finding, script));
  }
  if (summed) console.Result(say::FindingsSummedUp());
  if (!summed && tally.total() > tally.kept().size()) {
    console.Result(say::MoreFindings(tally.total() - tally.kept().size()));
  }
}

/// Ends with 1 where there is something to mend, so that a script can be checked unattended.
int Check(const ScriptOptions& options, const Script& script, Console& console) {
  const double size = options.size.value_or(script.size);
  const TypeStyle style = DefaultStyle(size, Relief::kEngraved, script);
  CheckSize check;
  check.size = size;
  check.groove = style.width;
  const bool each = options.all || options.output.json;
  FindingTally tally(each ? kMostFindings : kMostOfAKindSaid, kMostFindings);
  for (std::size_t glyph = 0; glyph < script.glyphs.size(); ++glyph) {
    console.CheckStop();
    console.Alive(static_cast<double>(glyph) / static_cast<double>(script.glyphs.size()));
    for (const ScriptFinding& finding : CheckGlyph(script, glyph, check)) tally.Add(finding);
  }
  const bool outlines = IsOutlineFont(script);
  if (options.output.json) {
    const Json head{{"size_mm", 1e3 * size},
                    {"groove_mm", 1e3 * check.groove},
                    {"probe_mm", 1e3 * check.probe_diameter},
                    {"outlines", outlines},
                    {"remarks", script.remarks}};
    WriteFindings(tally, script, head, console);
  } else {
    if (outlines) console.Result(say::ScriptIsOutlines());
    console.Result(say::CheckOutcome(tally.total(), script.glyphs.size(), check));
    SayFindings(tally, script, console);
  }
  return tally.total() == 0 && !outlines ? exit_code::kGood : exit_code::kFailed;
}

/// Throws where the files could not be read again.
WrittenScript Written(const Script& script, const std::string& svg_name) {
  try {
    return WriteScript(script, svg_name);
  } catch (const InputError& error) {
    throw InputError(say::NotConverted(error.what()));
  }
}

/// Throws LackError where something lies in a file's place that may be somebody's work: all but
/// what a former conversion left there. A link too, even a broken one, and what cannot be read.
void RequireFree(const std::string& path, std::string_view what) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(path, ignored)) || IsAsWritten(path)) return;
  throw LackError(say::InTheWay(path, what));
}

int Convert(const ScriptOptions& options, Script script, Console& console) {
  std::size_t joined = 0;
  for (Glyph& glyph : script.glyphs) {
    const std::size_t before = glyph.strokes.size();
    if (options.join) JoinStrokes(glyph, kJoinWithin);
    joined += before - glyph.strokes.size();
  }
  const std::string rules = fs::path(options.to).replace_extension(".toml").string();
  const WrittenScript written = Written(script, options.to);
  RequireFree(options.to, "font");
  RequireFree(rules, "rules");
  // neither stands there without the other where one cannot be written
  OutputFile font_file(options.to), rules_file(rules);
  font_file.Append(written.svg);
  rules_file.Append(written.toml);
  font_file.Finish();
  rules_file.Finish();
  if (options.output.json) {
    console.Json(Dump(Json{{"font", options.to},
                           {"rules", rules},
                           {"glyphs", script.glyphs.size()},
                           {"joined", joined}}));
    return exit_code::kGood;
  }
  console.Result(say::Converted(script.glyphs.size(), joined));
  console.Path(options.to);
  console.Path(rules);
  return exit_code::kGood;
}

int Picture(const ScriptOptions& options, const Script& script, Console& console) {
  WritePicture(options.picture, ScriptTable(script));
  const std::size_t shown = std::min(script.glyphs.size(), kMostInTable);
  if (options.output.json) {
    console.Json(Dump(
        Json{{"picture", options.picture}, {"shown", shown}, {"glyphs", script.glyphs.size()}}));
    return exit_code::kGood;
  }
  console.Result(say::TableOutcome(shown, script.glyphs.size()));
  for (std::size_t first = 0; first < shown; first += kRowOfTable) {
    std::string names;
    for (std::size_t i = first; i < std::min(first + kRowOfTable, shown); ++i) {
      names.append(i > first ? " " : "").append(OneLine(script.glyphs[i].name, 40));
    }
    console.Result(say::TableRow(first / kRowOfTable, names));
  }
  console.Result(say::PictureIn());
  console.Path(options.picture);
  return exit_code::kGood;
}

/// Only the glyphs of these characters, where the loader read more.
void KeepOnly(const std::string& only, Script& script) {
  if (only.empty()) return;
  const std::u32string wanted = ToCodePoints(only);
  std::vector<Glyph> kept;
  for (const auto& [character, name] : script.signs) {
    const std::size_t index = script.Find(name);
    const bool has = std::any_of(kept.begin(), kept.end(),
                                 [&name = name](const Glyph& glyph) { return glyph.name == name; });
    if (wanted.find(character) != std::u32string::npos && index != Script::npos && !has) {
      kept.push_back(script.glyphs[index]);
    }
  }
  if (kept.empty()) {
    throw InputError("--only: script " + script.name + " has no sign for any of '" + Shown(only) +
                     "'; name others");
  }
  script.glyphs = std::move(kept);
  const auto gone = [&script](const std::string& name) {
    return script.Find(name) == Script::npos;
  };
  std::erase_if(script.signs, [&](const auto& sign) { return gone(sign.second); });
  std::erase_if(script.contractions, [&](const Contraction& contraction) {
    return std::any_of(contraction.signs.begin(), contraction.signs.end(), gone);
  });
  script.digits.clear();
  script.numeral_sign.clear();
  script.forms.clear();
}

void CheckUse(const ScriptOptions& options) {
  const std::vector<std::string> known = {"list", "info", "check", "convert", "picture"};
  const std::string& action = options.action;
  if (std::find(known.begin(), known.end(), action) == known.end()) {
    throw UsageError(say::NotAnAction("script", action, NearestWord(action, known),
                                      "list, info, check, convert or picture"));
  }
  const auto only_for = [&action](const char* option, bool given, const char* owner) {
    if (given && action != owner) throw UsageError(say::NotOfThisAction(option, action));
  };
  only_for("--size-mm", options.size.has_value(), "check");
  only_for("--all", options.all, "check");
  only_for("--to", !options.to.empty(), "convert");
  only_for("--join", options.join, "convert");
  only_for("--picture", !options.picture.empty(), "picture");
  if (action == "list" && (!options.script.empty() || !options.only.empty())) {
    throw UsageError(say::NotOfThisAction("a script's name", action));
  }
  if (action != "list" && options.script.empty()) throw UsageError(say::NoScriptNamed(action));
  if (action == "convert" && options.to.empty()) {
    throw UsageError(say::NeedsOther("script convert", "--to"));
  }
  if (action == "picture" && options.picture.empty()) {
    throw UsageError(say::NeedsOther("script picture", "--picture"));
  }
  if (!options.to.empty() && LowerCase(fs::path(options.to).extension().string()) != ".svg") {
    throw UsageError(say::NotAnSvgPath(options.to));
  }
}

}  // namespace

void AddOptions(CLI::App& app, ScriptOptions& options) {
  namespace help = say::help;
  AddPath(app, "ACTION", "WORD", options.action, help::kScriptAction);
  AddPath(app, "SCRIPT", "NAME", options.script, help::kScriptName);
  AddPath(app, "--only", "TEXT", options.only, help::kScriptOnly);
  AddNumber(app, "--size-mm", options.size, 1, 1000, 1e-3, help::kScriptSize);
  AddFlag(app, "--all", options.all, help::kScriptAll);
  AddPath(app, "--to", "FILE", options.to, help::kScriptTo);
  AddFlag(app, "--join", options.join, help::kScriptJoin);
  AddPicture(app, options.picture, help::kScriptPicture);
  AddOptions(app, options.output);
}

int Run(const ScriptOptions& options, Console& console) {
  CheckUse(options);
  if (options.action == "list") return List(options, console);
  if (!options.picture.empty()) CheckPicturePath(options.picture);
  Script script = LoadScriptNamed(options.script, options.only);
  for (const std::string& remark : script.remarks) console.Remark(remark);
  KeepOnly(options.only, script);
  console.CheckStop();
  if (options.action == "info") return Info(options, script, console);
  if (options.action == "check") return Check(options, script, console);
  if (options.action == "convert") return Convert(options, std::move(script), console);
  return Picture(options, script, console);
}

}  // namespace moontrace
