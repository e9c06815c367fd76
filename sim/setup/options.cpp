#include "sim/setup/options.h"

#include <CLI/App.hpp>
#include <charconv>
#include <string_view>

#include "sim/picture/picture_file.h"
#include "sim/picture/structure_messages.h"
#include "sim/setup/help.h"
#include "sim/setup/setup_messages.h"
#include "sim/setup/writing_messages.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"
#include "textures/base/units.h"
#include "textures/base/utf8.h"
#include "textures/fonts/fallback.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/layout.h"
#include "textures/typeset/taught.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

namespace {

constexpr double kLongest = 1000;  // [mm], of anything on a page
constexpr std::size_t kMaxTextBytes = std::size_t{16} << 20U;

namespace help = say::help;

/// A choice between words.
template <typename Value>
void AddChoice(CLI::App& app, const std::string& name, const std::string& first, Value first_value,
               const std::string& second, Value second_value, Value& value,
               const std::string& description) {
  AddValue(
      app, name, "WORD",
      [=, &value](const std::string& given) {
        if (given != first && given != second) {
          throw UsageError(say::NotAChoice(name, given, first + " or " + second));
        }
        value = given == first ? first_value : second_value;
      },
      description);
}

PageSpec ParsePage(const std::string& as_given) {
  const std::string given = LowerCase(as_given);
  if (given == "a4" || given == "a5" || given == "workspace") return FindPage(given);
  const std::size_t by = given.find('x');
  double width = 0;
  double height = 0;
  if (by == std::string::npos || !ParseNumber(std::string_view(given).substr(0, by), width) ||
      !ParseNumber(std::string_view(given).substr(by + 1), height)) {
    throw UsageError(say::NotAPage(as_given));
  }
  ReadNumber("width of --page", given.substr(0, by), 1, kLongest);
  ReadNumber("height of --page", given.substr(by + 1), 1, kLongest);
  return FindPage(given);
}

/// How headings, quotations and links are read and set.
StructureStyle StructureOf(const StyleOptions& options, const Label& from) {
  StructureStyle style;
  style.read = options.structure || from.structure.value_or(false);
  if (!style.read) {
    if (options.heading_scale) throw UsageError(say::NeedsOther("--heading-scale", "--structure"));
    if (options.heading_relief) {
      throw UsageError(say::NeedsOther("--heading-relief", "--structure"));
    }
    if (options.structure_texture) {
      throw UsageError(say::NeedsOther("--structure-texture", "--structure"));
    }
  }
  const std::optional<double> scale =
      options.heading_scale ? options.heading_scale : from.heading_scale;
  style.heading_scale = scale.value_or(style.heading_scale);
  style.heading_relief = options.heading_relief;
  if (!style.heading_relief && from.heading_embossed) {
    style.heading_relief = *from.heading_embossed ? Relief::kEmbossed : Relief::kEngraved;
  }
  style.texture = options.structure_texture || from.structure_texture.value_or(false);
  return style;
}

}  // namespace

void AddPicture(CLI::App& app, std::string& path, const std::string& description) {
  AddValue(
      app, "--picture", "FILE",
      [&path](const std::string& given) {
        if (given.empty()) throw UsageError(say::ValueEmpty("--picture"));
        if (!HasPictureEnding(given)) throw UsageError(say::NotAPicture("--picture", given));
        path = given;
      },
      description);
}

void AddSeed(CLI::App& app, std::uint64_t& seed, bool* given_at_all) {
  AddValue(
      app, "--seed", "NUMBER",
      [&seed, given_at_all](const std::string& given) {
        const char* end = given.data() + given.size();
        const std::from_chars_result read = std::from_chars(given.data(), end, seed);
        if (given.empty() || read.ec != std::errc() || read.ptr != end) {
          throw UsageError(say::NotAWholeNumber("--seed", given));
        }
        if (given_at_all != nullptr) *given_at_all = true;
      },
      help::kSeed);
}

void AddOptions(CLI::App& app, OutputOptions& options) {
  BeginGroup(app, help_group::kOutput);
  AddFlag(app, "--json", options.json, help::kJson);
  AddFlag(app, "--quiet", options.quiet, help::kQuiet);
}

void AddOptions(CLI::App& app, TextOptions& options) {
  BeginGroup(app, help_group::kText);
  AddValue(
      app, "TEXT", "TEXT", [&options](const std::string& given) { options.text = given; },
      help::kText);
  AddPath(app, "--file", "FILE", options.file, help::kFile);
}

void AddOptions(CLI::App& app, StyleOptions& options) {
  BeginGroup(app, help_group::kLetters);
  AddNumber(app, "--size-mm", options.size, 1, kLongest, kMillimetre, help::kSize);
  AddNumber(app, "--width-mm", options.width, 0.001, kLongest, kMillimetre, help::kWidth);
  AddNumber(app, "--depth-mm", options.depth, 0.001, kLongest, kMillimetre, help::kDepth);
  AddNumber(app, "--rounding-mm", options.rounding, 0.0001, kLongest, kMillimetre, help::kRounding);
  app.add_flag_function(
      "--embossed", [&options](std::int64_t given) { options.embossed = given > 0; },
      help::kEmbossed);
  const auto add_word = [&app](const std::string& name, std::optional<std::string>& word,
                               const char* description) {
    AddValue(
        app, name, "NAME", [&word](const std::string& given) { word = given; }, description);
  };
  add_word("--script", options.script, help::kScript);
  add_word("--h-form", options.h_form, help::kHForm);
  AddNumber(app, "--grade", options.grade, 0, 10, 1, help::kGrade);
  add_word("--table", options.table, help::kTable);
  add_word("--fallback-script", options.fallback_script, help::kFallbackScript);
  add_word("--only", options.only, help::kOnly);
  AddChoice<std::optional<bool>>(app, "--punctuation", "today", false, "older", true,
                                 options.older_punctuation, help::kPunctuation);
  AddNumber(app, "--slant-deg", options.slant, -30, 30, kDegree, help::kSlant);
  AddNumber(app, "--stretch", options.stretch, 0.5, 2, 1, help::kStretch);
  BeginGroup(app, help_group::kStructure);
  AddFlag(app, "--structure", options.structure, help::kStructure);
  AddNumber(app, "--heading-scale", options.heading_scale, 1, 5, 1, help::kHeadingScale);
  AddChoice<std::optional<Relief>>(app, "--heading-relief", "engraved", Relief::kEngraved,
                                   "embossed", Relief::kEmbossed, options.heading_relief,
                                   help::kHeadingRelief);
  AddChoice(app, "--structure-texture", "yes", true, "no", false, options.structure_texture,
            help::kStructureTexture);
  AddOptions(app, options.links);
}

void AddOptions(CLI::App& app, LayoutOptions& options) {
  BeginGroup(app, help_group::kPage);
  AddValue(
      app, "--page", "PAPER",
      [&options](const std::string& given) {
        options.page = ParsePage(given);
        options.page_named = true;
      },
      help::kPaper);
  AddNumber(app, "--margin-mm", options.margin, 0, kLongest, kMillimetre, help::kMargin);
  AddNumber(app, "--letter-gap-mm", options.letter_gap, 0, kLongest, kMillimetre, help::kLetterGap);
  AddNumber(app, "--word-gap-mm", options.word_gap, 0, kLongest, kMillimetre, help::kWordGap);
  AddNumber(app, "--line-pitch-mm", options.line_pitch, 0.1, kLongest, kMillimetre,
            help::kLinePitch);
  AddNumber(app, "--paragraph-gap-mm", options.paragraph_gap, 0, kLongest, kMillimetre,
            help::kParagraphGap);
  AddValue(
      app, "--lines", "WORD",
      [&options](const std::string& given) {
        const std::optional<LineDirection> lines = LineDirectionOf(given);
        if (!lines) throw UsageError(say::NotAChoice("--lines", given, kLineDirections));
        options.lines = *lines;
      },
      help::kLines);
  AddPath(app, "--hyphenate", "LANGUAGE", options.hyphenation, help::kHyphenate);
  AddPath(app, "--running-head", "TEXT", options.running_head, help::kRunningHead);
  AddFlag(app, "--page-numbers", options.page_numbers, help::kPageNumbers);
  AddOptions(app, options.sheet);
}

void AddOptions(CLI::App& app, Surface& surface) {
  BeginGroup(app, help_group::kFeel);
  AddChoice(app, "--law", "potential", ForceLaw::kPotential, "paper", ForceLaw::kPaper, surface.law,
            help::kLaw);
}

void AddOptions(CLI::App& app, FeelOptions& options) {
  AddOptions(app, options.scene.surface);
  AddChoice(app, "--render", "proxy", Rendering::kProxy, "direct", Rendering::kDirect,
            options.scene.rendering, help::kRender);
  const auto add = [&app](const std::string& name, double& value, double low, double high,
                          double scale, const char* description) {
    AddValue(
        app, name, "NUMBER",
        [=, &value](const std::string& given) {
          value = scale * ReadNumber(name, given, low, high);
        },
        description);
  };
  add("--friction", options.scene.friction, 0, 2, 1, help::kFriction);
  add("--tilt-deg", options.scene.tilt, -60, 60, kDegree, help::kTilt);
  AddPath(app, "--model", "FILE", options.model, help::kModel);
  AddPath(app, "--label", "NAME", options.label, help::kLabel);
  AddValue(
      app, "--unlabelled", "WORD",
      [&options](const std::string& given) {
        constexpr std::array<std::string_view, 3> kWords = {"nothing", "plain",
                                                            "contacts"};  // as Unlabelled
        const auto* found = std::find(kWords.begin(), kWords.end(), std::string_view(given));
        if (found == kWords.end()) {
          throw UsageError(say::NotAChoice("--unlabelled", given, "nothing, plain or contacts"));
        }
        options.scene.unlabelled = static_cast<Unlabelled>(found - kWords.begin());
      },
      help::kUnlabelled);
}

std::string ReadText(const TextOptions& options, const std::string& command, Console& console) {
  const bool from_argument = options.text && *options.text != "-";
  if (options.text && !options.file.empty()) throw UsageError(say::TwoTexts());
  if (from_argument) return *options.text;
  if (!options.text && options.file.empty()) throw UsageError(say::NoText(command));
  if (options.text || options.file == "-") {
    std::string text;
    char block[65536];
    while (console.in().read(block, sizeof block) || console.in().gcount() > 0) {
      text.append(block, static_cast<std::size_t>(console.in().gcount()));
      if (text.size() > kMaxTextBytes) throw InputError(say::CannotReadInput());
    }
    console.CheckStop();
    if (console.in().bad()) throw InputError(say::CannotReadInput());
    return text;
  }
  try {
    std::string text = ReadTextOrPipe(options.file, kMaxTextBytes);
    RequireUtf8(text, options.file);
    return text;
  } catch (const InputError&) {
    console.CheckStop();  // the signal ended a wait for a pipe: that is no fault of the file
    throw;
  }
}

Script ScriptOf(const StyleOptions& options, const Label* label, std::string_view text) {
  const std::optional<std::string> named =
      options.script || label == nullptr ? options.script : label->script;
  // A fallback script may write what this one lacks, so this one is then read whole.
  Script script = FindScript(named.value_or("moon"), options.fallback_script ? "" : text);
  if (options.fallback_script)
    Borrow(script, FindScript(*options.fallback_script), *options.fallback_script);
  return script;
}

TypeStyle StyleOf(const StyleOptions& options, const LayoutOptions& layout, Script& script,
                  const Label* label) {
  const Label none;
  const Label& from = label != nullptr ? *label : none;
  const auto chosen = [](const auto& first, const auto& second) { return first ? first : second; };

  const double size = chosen(options.size, from.size).value_or(script.size);
  const bool embossed = chosen(options.embossed, from.embossed).value_or(false);
  TypeStyle style = DefaultStyle(size, embossed ? Relief::kEmbossed : Relief::kEngraved, script);
  const double width = chosen(options.width, from.width).value_or(style.width);
  const double scale = width / style.width;
  style.width = width;
  style.depth = chosen(options.depth, from.depth).value_or(scale * style.depth);
  style.rounding = chosen(options.rounding, from.rounding).value_or(scale * style.rounding);
  style.blend_radius *= scale;
  style.grade = chosen(options.grade, from.grade).value_or(style.grade);
  style.h_form = chosen(options.h_form, from.h_form).value_or(style.h_form);
  style.letter_gap = layout.letter_gap.value_or(style.letter_gap);
  style.word_gap = layout.word_gap.value_or(style.word_gap);
  style.line_pitch = layout.line_pitch.value_or(style.line_pitch);
  style.table = chosen(options.table, from.table).value_or("");
  style.older_punctuation =
      chosen(options.older_punctuation, from.older_punctuation).value_or(false);
  if (options.only) style.only = TaughtSigns(*options.only, script);
  style.lines = layout.lines;
  if (!layout.hyphenation.empty() && layout.lines == LineDirection::kAlternate) {
    throw UsageError(say::AlternateLinesBreakWords());
  }
  style.hyphenation = layout.hyphenation;
  style.running_head = layout.running_head;
  style.page_numbers = layout.page_numbers;
  style.paragraph_gap = layout.paragraph_gap;
  style.rules = RulesOf(layout.sheet);
  style.texture = SheetTextureOf(layout.sheet, from);
  style.links = LinksOf(options.links, from);
  style.rules.makes_room = style.rules.lines && (!layout.line_pitch || layout.usual_pitch);
  style.form = {chosen(options.slant, from.slant).value_or(0),
                chosen(options.stretch, from.stretch).value_or(1)};
  style.structure = StructureOf(options, from);
  script = Reshaped(script, style.form);
  if (style.lines == LineDirection::kAlternate) AddGuides(script, style);
  return style;
}

PageSpec PageOf(const LayoutOptions& layout) {
  PageSpec page = layout.page;
  page.margin = layout.margin.value_or(page.margin);
  return page;
}

}  // namespace moontrace
