#include "sim/setup/sheet_options.h"

#include "sim/console/console.h"
#include "sim/physics/label.h"
#include "sim/picture/sheet_messages.h"
#include "sim/setup/help.h"
#include "sim/setup/setup_messages.h"
#include "textures/base/units.h"
#include "textures/typeset/sheet_texture.h"

namespace moontrace {

namespace {

constexpr double kLongest = 1000;  // [mm]

}  // namespace

void AddOptions(CLI::App& app, SheetOptions& options) {
  BeginGroup(app, help_group::kSheet);
  const auto add = [&app](const char* name, std::optional<double>& value, double low,
                          const char* description) {
    AddNumber(app, name, value, low, kLongest, kMillimetre, description);
  };
  AddFlag(app, "--rules", options.rules, say::help::kRules);
  add("--rule-width-mm", options.rule_width, 0.01, say::help::kRuleWidth);
  add("--rule-height-mm", options.rule_height, 0.001, say::help::kRuleHeight);
  AddFlag(app, "--raised-margin", options.raised_margin, say::help::kRaisedMargin);
  add("--raised-margin-width-mm", options.margin_width, 0.01, say::help::kRaisedMarginWidth);
  add("--raised-margin-height-mm", options.margin_height, 0.001, say::help::kRaisedMarginHeight);
  AddValue(
      app, "--texture", "NAME",
      [&options](const std::string& given) {
        if (!IsTextureWord(given)) {
          throw UsageError(say::NotAChoice("--texture", given, say::kTextureWords));
        }
        options.texture = given;
      },
      say::help::kTexture);
  add("--texture-amplitude-mm", options.amplitude, 0.0001, say::help::kTextureAmplitude);
  add("--texture-wavelength-mm", options.wavelength, 0.01, say::help::kTextureWavelength);
  AddNumber(app, "--texture-angle-deg", options.angle, -180, 180, kDegree,
            say::help::kTextureAngle);
}

RuleStyle RulesOf(const SheetOptions& options) {
  if (!options.rules && (options.rule_width || options.rule_height)) {
    throw UsageError(
        say::NeedsOther(options.rule_width ? "--rule-width-mm" : "--rule-height-mm", "--rules"));
  }
  if (!options.raised_margin && (options.margin_width || options.margin_height)) {
    throw UsageError(say::NeedsOther(
        options.margin_width ? "--raised-margin-width-mm" : "--raised-margin-height-mm",
        "--raised-margin"));
  }
  RuleStyle rules;
  rules.lines = options.rules;
  rules.margin = options.raised_margin;
  rules.width = options.rule_width.value_or(0);
  rules.height = options.rule_height.value_or(0);
  rules.margin_width = options.margin_width.value_or(0);
  rules.margin_height = options.margin_height.value_or(0);
  return rules;
}

SheetTexture SheetTextureOf(const SheetOptions& options, const Label& label) {
  const std::string word = (options.texture ? options.texture : label.texture).value_or("none");
  const std::optional<double> amplitude =
      options.amplitude ? options.amplitude : label.texture_amplitude;
  const std::optional<double> wavelength =
      options.wavelength ? options.wavelength : label.texture_wavelength;
  SheetTexture texture;
  if (word == "none") {
    if (options.amplitude) throw UsageError(say::NeedsOther("--texture-amplitude-mm", "--texture"));
    if (options.wavelength) {
      throw UsageError(say::NeedsOther("--texture-wavelength-mm", "--texture"));
    }
    if (options.angle) throw UsageError(say::NeedsOther("--texture-angle-deg", "--texture"));
    return texture;
  }
  PaperTexture& paper = texture.paper.emplace();
  paper.kind = PaperKindOf(word).value_or(PaperKind::kSampled);
  paper.amplitude = amplitude.value_or(paper.amplitude);
  paper.wavelength = wavelength.value_or(paper.wavelength);
  paper.angle = options.angle.value_or(0);
  if (paper.kind == PaperKind::kSampled) {
    paper.tiled = wavelength.has_value();
    texture.file = word;
    ReadHeights(texture);
  }
  return texture;
}

}  // namespace moontrace
