#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "sim/console/console.h"
#include "sim/physics/label.h"
#include "sim/physics/scene_options.h"
#include "sim/setup/cli_app.h"
#include "sim/setup/link_options.h"
#include "sim/setup/sheet_options.h"
#include "textures/field/surface.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// Options that several commands share, as given; each command adds the groups that it uses.
/// Lengths are metres once read. AddOptions binds a group to an app; reading throws UsageError for
/// what no machine could take, whatever text and script come with it.

/// `--json`, `--quiet`.
struct OutputOptions {
  bool json = false;
  bool quiet = false;
};

/// A text: as argument, from `--file`, or from standard input ("-").
struct TextOptions {
  std::optional<std::string> text;
  std::string file;
};

/// The letters.
struct StyleOptions {
  std::optional<double> size, width, depth, rounding;  ///< [m]
  std::optional<bool> embossed;
  std::optional<std::string> script, h_form;
  std::optional<double> grade;
  std::optional<std::string> table, only, fallback_script;
  std::optional<bool> older_punctuation;
  std::optional<double> slant, stretch;  ///< [rad], of widths
  bool structure = false;
  std::optional<double> heading_scale;
  std::optional<Relief> heading_relief;
  bool structure_texture = false;
  LinkOptions links;
};

/// The paper and the spaces on it.
struct LayoutOptions {
  PageSpec page{"a4", 0.210, 0.297, 0.015};
  bool page_named = false;  ///< by --page
  /// A short text lies in the middle: of the sheet that was named, otherwise of one that is cut to
  /// it, see FitSheet.
  bool centred = false;
  std::optional<double> margin, letter_gap, word_gap, line_pitch, paragraph_gap;  ///< [m]
  bool usual_pitch = false;  ///< the line pitch was made of the usual one, not given
  LineDirection lines = LineDirection::kLeftToRight;
  std::string hyphenation, running_head;  ///< empty: none
  bool page_numbers = false;
  SheetOptions sheet;
};

/// What is felt and how.
struct FeelOptions {
  SceneOptions scene;
  std::string model;  ///< MJCF file; empty = the shipped page
  std::string label;  ///< which of its labels, as NameOf gives it; empty: the first
};

void AddOptions(CLI::App& app, OutputOptions& options);
void AddOptions(CLI::App& app, TextOptions& options);
void AddOptions(CLI::App& app, StyleOptions& options);
void AddOptions(CLI::App& app, LayoutOptions& options);
/// `--law` only.
void AddOptions(CLI::App& app, Surface& surface);
/// `--law`, `--render`, `--friction`, `--tilt-deg`, `--model`, `--label`, `--unlabelled`.
void AddOptions(CLI::App& app, FeelOptions& options);
/// `--picture`; a path without an ending of pictures is a UsageError.
void AddPicture(CLI::App& app, std::string& path, const std::string& description);
/// `--seed`. `given_at_all`, unless null, becomes true if it was.
void AddSeed(CLI::App& app, std::uint64_t& seed, bool* given_at_all = nullptr);

/// The text of a command, at most 16 MB. Throws UsageError (none, two) and InputError.
std::string ReadText(const TextOptions& options, const std::string& command, Console& console);

/// The script asked for: command line, otherwise label, otherwise moon; with the signs of the one
/// to fall back on.
Script ScriptOf(const StyleOptions& options, const Label* label, std::string_view text = {});

/// The letters asked for: command line before label before the design's defaults. A width given
/// alone takes depth and rounding with it in proportion. Alternating lines add their guide lines to
/// the script.
TypeStyle StyleOf(const StyleOptions& options, const LayoutOptions& layout, Script& script,
                  const Label* label);
PageSpec PageOf(const LayoutOptions& layout);

}  // namespace moontrace
