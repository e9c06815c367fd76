#include "sim/setup/trial_parameters.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "sim/setup/setup_messages.h"
#include "sim/setup/typeset_report.h"
#include "textures/base/error.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/sheet_texture.h"

namespace moontrace {

namespace {

/// An absolute path: a record is replayed from any folder.
std::string Whole(const std::string& path) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(path, error).lexically_normal();
  return path.empty() || error ? path : whole.string();
}

/// The absolute path of a script's file; a script's name stays a name.
std::string WholeScript(const std::string& script) {
  return IsScriptPath(script) ? Whole(script) : script;
}

Json RulesJson(const RuleStyle& rules) {
  return {{"lines", rules.lines},
          {"margin", rules.margin},
          {"width_m", rules.width},
          {"height_m", rules.height},
          {"margin_width_m", rules.margin_width},
          {"margin_height_m", rules.margin_height}};
}

RuleStyle RulesFrom(const Json& json) {
  RuleStyle rules;
  rules.lines = json.at("lines");
  rules.margin = json.at("margin");
  rules.width = json.at("width_m");
  rules.height = json.at("height_m");
  rules.margin_width = json.at("margin_width_m");
  rules.margin_height = json.at("margin_height_m");
  return rules;
}

Json TextureJson(const SheetTexture& texture) {
  const PaperTexture& paper = *texture.paper;
  return {{"kind", NameOf(paper.kind)},
          {"amplitude_m", paper.amplitude},
          {"wavelength_m", paper.wavelength},
          {"angle_rad", paper.angle},
          {"seed", paper.seed},
          {"tiled", paper.tiled},
          {"file", Whole(texture.file)}};
}

SheetTexture TextureFrom(const Json& json) {
  SheetTexture texture;
  PaperTexture& paper = texture.paper.emplace();
  paper.kind = PaperKindOf(json.at("kind").get<std::string>()).value_or(PaperKind::kNoise);
  paper.amplitude = json.at("amplitude_m");
  paper.wavelength = json.at("wavelength_m");
  paper.angle = json.at("angle_rad");
  paper.seed = json.at("seed");
  paper.tiled = json.at("tiled");
  texture.file = json.at("file");
  ReadHeights(texture);
  return texture;
}

Json GuidanceJson(const TrialGuidance& guidance) {
  const GuidanceGains& gains = guidance.gains;
  return {{"mode", NameOf(guidance.mode)},
          {"help", guidance.help},
          {"stiffness_n_m", gains.stiffness},
          {"damping_n_s_m", gains.damping},
          {"dead_zone_widths", gains.dead_zone_widths},
          {"cap_n", gains.cap},
          {"bead_speed_m_s", gains.bead_speed},
          {"leash_widths", gains.leash_widths},
          {"cue_amplitude_n", gains.cue_amplitude}};
}

TrialGuidance GuidanceFrom(const Json& json) {
  TrialGuidance guidance;
  guidance.mode = GuidanceModeOf(json.at("mode").get<std::string>()).value_or(GuidanceMode::kOff);
  guidance.help = json.at("help");
  guidance.gains.stiffness = json.at("stiffness_n_m");
  guidance.gains.damping = json.at("damping_n_s_m");
  guidance.gains.dead_zone_widths = json.at("dead_zone_widths");
  guidance.gains.cap = json.at("cap_n");
  guidance.gains.bead_speed = json.at("bead_speed_m_s");
  guidance.gains.leash_widths = json.at("leash_widths");
  guidance.gains.cue_amplitude = json.at("cue_amplitude_n");
  return guidance;
}

// Metres as they are, not millimetres: a record must give back every bit.
Json StyleJson(const TypeStyle& style) {
  Json json = {{"size_m", style.size},
               {"width_m", style.width},
               {"depth_m", style.depth},
               {"rounding_m", style.rounding},
               {"blend_radius_m", style.blend_radius},
               {"embossed", style.relief == Relief::kEmbossed},
               {"letter_gap_m", style.letter_gap},
               {"word_gap_m", style.word_gap},
               {"line_pitch_m", style.line_pitch},
               {"grade", style.grade},
               {"h_form", style.h_form},
               {"table", style.table},
               {"only", style.only},
               {"lines", NameOf(style.lines)}};
  if (style.older_punctuation) json["older_punctuation"] = true;
  if (!style.hyphenation.empty()) json["hyphenation"] = style.hyphenation;
  if (!style.running_head.empty()) json["running_head"] = style.running_head;
  if (style.page_numbers) json["page_numbers"] = true;
  json["rules"] = RulesJson(style.rules);
  if (style.texture.paper) json["texture"] = TextureJson(style.texture);
  if (style.paragraph_gap) json["paragraph_gap_m"] = *style.paragraph_gap;
  json["links"] = {{"reach", NameOf(style.links.reach)}, {"depth", style.links.depth}};
  if (style.links.gap) json["links"]["gap_m"] = *style.links.gap;
  json["slant_rad"] = style.form.slant;
  json["stretch"] = style.form.stretch;
  json["structure"] = style.structure.read;
  json["heading_scale"] = style.structure.heading_scale;
  if (style.structure.heading_relief) {
    json["heading_embossed"] = *style.structure.heading_relief == Relief::kEmbossed;
  }
  json["structure_texture"] = style.structure.texture;
  return json;
}

TypeStyle StyleFrom(const Json& json) {
  TypeStyle style;
  style.size = json.at("size_m");
  style.width = json.at("width_m");
  style.depth = json.at("depth_m");
  style.rounding = json.at("rounding_m");
  style.blend_radius = json.at("blend_radius_m");
  style.relief = json.at("embossed").get<bool>() ? Relief::kEmbossed : Relief::kEngraved;
  style.letter_gap = json.at("letter_gap_m");
  style.word_gap = json.at("word_gap_m");
  style.line_pitch = json.at("line_pitch_m");
  style.grade = json.at("grade");
  style.h_form = json.at("h_form");
  // Records of earlier versions have none of these.
  style.table = json.value("table", std::string());
  style.older_punctuation = json.value("older_punctuation", false);
  style.hyphenation = json.value("hyphenation", std::string());
  style.running_head = json.value("running_head", std::string());
  style.page_numbers = json.value("page_numbers", false);
  style.only = json.value("only", std::vector<std::string>());
  style.lines =
      LineDirectionOf(json.value("lines", std::string())).value_or(LineDirection::kLeftToRight);
  if (json.contains("rules")) style.rules = RulesFrom(json.at("rules"));
  if (json.contains("texture")) style.texture = TextureFrom(json.at("texture"));
  if (json.contains("paragraph_gap_m")) style.paragraph_gap = json.at("paragraph_gap_m");
  if (json.contains("links")) {
    const Json& links = json.at("links");
    style.links.reach =
        LinkReachOf(links.at("reach").get<std::string>()).value_or(LinkReach::kNone);
    style.links.depth = links.at("depth");
    if (links.contains("gap_m")) style.links.gap = links.at("gap_m").get<double>();
  }
  style.form = {json.value("slant_rad", 0.0), json.value("stretch", 1.0)};
  style.structure.read = json.value("structure", false);
  style.structure.heading_scale = json.value("heading_scale", style.structure.heading_scale);
  if (json.contains("heading_embossed")) {
    style.structure.heading_relief =
        json.at("heading_embossed").get<bool>() ? Relief::kEmbossed : Relief::kEngraved;
  }
  style.structure.texture = json.value("structure_texture", false);
  return style;
}

}  // namespace

std::string ParametersJson(const TrialParameters& parameters, const TrialSetup& setup) {
  Json json;
  json["text"] = parameters.text;
  json["script"] = WholeScript(parameters.script);
  if (setup.script != nullptr) json["fallback_script"] = WholeScript(setup.script->borrowed_from);
  json["style"] = StyleJson(parameters.style);
  json["paper"] = {{"name", parameters.paper.name},
                   {"width_m", parameters.paper.width},
                   {"height_m", parameters.paper.height},
                   {"margin_m", parameters.paper.margin}};
  json["page"] = parameters.page;
  json["blank"] = parameters.blank;
  if (setup.guidance.on()) json["guidance"] = GuidanceJson(setup.guidance);
  json["plan"] = {{"speed_m_s", setup.plan.speed},
                  {"air_speed_m_s", setup.plan.air_speed},
                  {"clearance_m", setup.plan.clearance},
                  {"press_n", setup.plan.press},
                  {"ridge_press_n", setup.plan.ridge_press.value_or(setup.plan.press)},
                  {"settle_s", setup.plan.settle},
                  {"dot_rest_s", setup.plan.dot_rest}};
  if (setup.device) json["device_profile"] = setup.device->name;
  json["hand"] = {{"mass_kg", setup.hand.mass},
                  {"stiffness_n_m", setup.hand.stiffness},
                  {"damping_n_s_m", setup.hand.damping},
                  {"tremor_rms_m", setup.hand.tremor_rms},
                  {"tremor_low_hz", setup.hand.tremor_low},
                  {"tremor_high_hz", setup.hand.tremor_high},
                  {"drift", setup.hand.drift},
                  {"drift_wavelength_m", setup.hand.drift_wavelength},
                  {"late_ticks", setup.hand.late_ticks}};
  return Dump(json);
}

TrialParameters ReadParameters(const std::string& json_text, const std::string& folder) {
  try {
    const Json json = Json::parse(json_text);
    TrialParameters parameters;
    parameters.text = json.at("text");
    parameters.script = json.at("script");
    parameters.fallback_script = json.value("fallback_script", std::string());
    parameters.style = StyleFrom(json.at("style"));
    const Json& paper = json.at("paper");
    parameters.paper = {paper.at("name"), paper.at("width_m"), paper.at("height_m"),
                        paper.at("margin_m")};
    parameters.page = json.at("page");
    parameters.blank = json.at("blank");
    if (json.contains("guidance")) parameters.guidance = GuidanceFrom(json.at("guidance"));
    return parameters;
  } catch (const Json::exception& error) {
    throw InputError(say::BadParameters(folder, error.what()));
  }
}

}  // namespace moontrace
