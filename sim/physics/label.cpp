#include "sim/physics/label.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "textures/base/error.h"
#include "textures/base/text_file.h"
#include "textures/base/toml_reader.h"
#include "textures/base/units.h"
#include "textures/typeset/sheet_texture.h"

namespace moontrace {
namespace {

constexpr double kGreatestAt = 1e5;  ///< [mm]; a larger value is a typing error

std::optional<double> Length(const TomlTable& table, const std::string& key) {
  if (!table.Has(key)) return std::nullopt;
  const double millimetres = table.Number(key);
  if (!(millimetres > 0)) table.Fail(key, "not above zero; write a length in millimetres");
  return millimetres * kMillimetre;
}

std::optional<double> Number(const TomlTable& table, const std::string& key) {
  if (!table.Has(key)) return std::nullopt;
  return table.Number(key);
}

std::optional<bool> YesOrNo(const TomlTable& table, const std::string& key) {
  if (!table.Has(key)) return std::nullopt;
  return table.Bool(key);
}

std::optional<std::string> Word(const TomlTable& table, const std::string& key) {
  if (!table.Has(key)) return std::nullopt;
  return table.String(key);
}

glm::dvec2 Position(const TomlTable& table, const std::string& key) {
  const std::vector<double> at = table.Numbers(key);
  if (at.size() != 2) table.Fail(key, "not two numbers; write [x, y] in millimetres");
  if (std::max(std::abs(at[0]), std::abs(at[1])) > kGreatestAt) {
    table.Fail(key, "more than 100 m away; write [x, y] in millimetres");
  }
  return glm::dvec2(at[0], at[1]) * kMillimetre;
}

/// Splits "GEOM[:n]"; what follows the last colon is a number only if it is all digits.
void SplitGeom(const std::string& rest, Label& label) {
  label.geom = rest;
  const std::size_t colon = rest.rfind(':');
  if (colon == std::string::npos || colon == 0) return;
  int number = 0;
  const char* end = rest.data() + rest.size();
  const auto [stop, error] = std::from_chars(rest.data() + colon + 1, end, number);
  if (error != std::errc() || stop != end || number < 0) return;
  label.geom = rest.substr(0, colon);
  label.number = number;
}

void ReadLinks(const TomlTable& table, Label& label) {
  if (table.Has("links")) {
    label.links = LinkReachOf(table.String("links"));
    if (!label.links) table.Fail("links", std::string("not one of ") + kLinkReaches);
  }
  if (table.Has("link_depth")) {
    label.link_depth = table.Number("link_depth");
    if (!(*label.link_depth >= 0.05 && *label.link_depth <= 1)) {
      table.Fail("link_depth", "not from 0.05 to 1; write a share of the letters' depth");
    }
  }
  label.link_gap = Length(table, "link_gap_mm");
}

void ReadPunctuation(const TomlTable& table, Label& label) {
  if (!table.Has("punctuation")) return;
  const std::string given = table.String("punctuation");
  if (given != "today" && given != "older") table.Fail("punctuation", "neither today nor older");
  label.older_punctuation = given == "older";
}

void ReadTexture(const TomlTable& table, Label& label) {
  label.texture = Word(table, "texture");
  if (label.texture && !IsTextureWord(*label.texture)) {
    table.Fail("texture", "not one of none, sine, grid, noise, or a .pgm file");
  }
  label.texture_amplitude = Length(table, "texture_amplitude_mm");
  label.texture_wavelength = Length(table, "texture_wavelength_mm");
}

/// Where on its geom, and how that answers.
void ReadPlace(const TomlTable& table, Label& label) {
  if (table.Has("at_mm") && table.Has("middle_mm")) {
    table.Fail("middle_mm", "at_mm is there too; write one of them");
  }
  label.at_given = table.Has("at_mm");
  if (label.at_given) label.at = Position(table, "at_mm");
  if (table.Has("middle_mm")) label.middle = Position(table, "middle_mm");
  if (table.Has("face")) {
    label.face = FaceOf(table.String("face"));
    if (!label.face) table.Fail("face", std::string("not one of ") + kFaceNames);
    if (!label.middle && !label.at_given) label.middle = {0, 0};
  }
  if (table.Has("turn_deg")) {
    label.turn = table.Number("turn_deg") * std::numbers::pi / 180;
    if (!(std::abs(label.turn) <= 2 * std::numbers::pi)) {
      table.Fail("turn_deg", "not from -360 to 360; write degrees to the left");
    }
  }
  const auto within = [&](const std::string& key, double least, double most, const char* mend) {
    if (!table.Has(key)) return std::optional<double>();
    const double value = table.Number(key);
    if (!(value >= least && value <= most)) table.Fail(key, mend);
    return std::optional<double>(value);
  };
  label.stiffness = within("stiffness_n_per_m", 10, 1e5, "not from 10 to 100000; paper has 1000");
  label.force_cap = within("force_cap_n", 0.05, 50, "not from 0.05 to 50; paper has 4");
}

}  // namespace

std::string NameOf(const Label& label) {
  return label.number == 0 ? label.geom : label.geom + ":" + std::to_string(label.number);
}

bool IsLabelName(const std::string& name) { return name.rfind(kLabelPrefix, 0) == 0; }

Label ParseLabel(const std::string& name, const std::string& data, const std::string& where) {
  const std::string place = where + ": text '" + OneLine(name) + "'";
  Label label;
  if (IsLabelName(name)) SplitGeom(name.substr(kLabelPrefix.size()), label);
  if (label.geom.empty()) {
    throw InputError(place + ": names no geom; write moontrace:GEOM or moontrace:GEOM:1");
  }
  const TomlTable table = TomlTable::ParseInline(data, place);
  label.text = table.String("text", "");
  ReadPlace(table, label);
  label.size = Length(table, "size_mm");
  label.width = Length(table, "width_mm");
  label.depth = Length(table, "depth_mm");
  label.rounding = Length(table, "rounding_mm");
  if (table.Has("embossed")) label.embossed = table.Bool("embossed");
  label.script = Word(table, "script");
  label.h_form = Word(table, "h_form");
  if (table.Has("grade")) label.grade = table.Number("grade");
  ReadPunctuation(table, label);
  label.table = Word(table, "table");
  if (table.Has("slant_deg")) label.slant = table.Number("slant_deg") * std::numbers::pi / 180;
  label.stretch = Number(table, "stretch");
  label.structure = YesOrNo(table, "structure");
  label.heading_scale = Number(table, "heading_scale");
  label.heading_embossed = YesOrNo(table, "heading_embossed");
  label.structure_texture = YesOrNo(table, "structure_texture");
  ReadLinks(table, label);
  ReadTexture(table, label);
  table.FailUnknown();
  return label;
}

}  // namespace moontrace
