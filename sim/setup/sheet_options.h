#pragma once

#include <optional>
#include <string>

#include "sim/setup/cli_app.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

struct Label;

/// What the sheet has besides text, as given: rules, a raised margin, a paper texture.
struct SheetOptions {
  bool rules = false, raised_margin = false;
  std::optional<double> rule_width, rule_height;      ///< [m]
  std::optional<double> margin_width, margin_height;  ///< [m]
  std::optional<std::string> texture;                 ///< a kind, "none" or the path of a PGM
  std::optional<double> amplitude, wavelength;        ///< [m]
  std::optional<double> angle;                        ///< [rad]
};

/// `--rules`, `--raised-margin` and their sizes; `--texture` and its sizes.
void AddOptions(CLI::App& app, SheetOptions& options);

/// Throws UsageError for a size without what it sizes, InputError for a picture that cannot be
/// read. The label's texture counts where the command line gives none.
RuleStyle RulesOf(const SheetOptions& options);
SheetTexture SheetTextureOf(const SheetOptions& options, const Label& label);

}  // namespace moontrace
