#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "textures/objects/solid.h"
#include "textures/typeset/style.h"

namespace moontrace {

/// Text on a geom, from `<custom><text name="moontrace:GEOM[:n]" data="{text='MUG', size_mm=10,
/// at_mm=[0,0]}"/>`: one TOML inline table with the command line's keys. Absent keys are left to
/// the command line's defaults.
struct Label {
  std::string geom;    ///< its name, or BODY or BODY/N for a geom without one, see GeomNamed
  std::string fitted;  ///< name of the geom that was fitted to a mesh for it; else empty
  double error = 0;    ///< of that fit, greatest distance from the mesh [m]
  int carrier = -1;    ///< MuJoCo's number of the geom that it lies on, once it is found
  int named = -1;      ///< and of the geom that it names
  int number = 0;
  bool implied = false;  ///< no label of the model's: a geom without one that is felt plain
  std::string text;      ///< may be empty: the program's text goes there
  /// The page's lower left corner on the face, from its middle [m]: of a top face in the geom's own
  /// frame.
  glm::dvec2 at{0, 0};
  bool at_given = false;
  std::optional<glm::dvec2> middle;  ///< of the text, on the face [m]; then `at` does not count
  std::optional<Face> face;          ///< none: UsualFace
  double turn = 0;                   ///< of the page on the face, to the left [rad]
  std::optional<double> stiffness;   ///< of the geom [N/m]
  std::optional<double> force_cap;   ///< of the geom [N]
  std::optional<double> size, width, depth, rounding;  ///< [m]
  std::optional<bool> embossed;
  std::optional<std::string> script, h_form;
  std::optional<double> grade;
  std::optional<bool> older_punctuation;
  std::optional<std::string> table;      ///< of liblouis, for Braille
  std::optional<double> slant, stretch;  ///< of letters [rad], of widths
  std::optional<bool> structure, heading_embossed, structure_texture;
  std::optional<double> heading_scale;
  std::optional<LinkReach> links;
  std::optional<std::string> texture;  ///< of the sheet: a kind, "none", a .pgm
  std::optional<double> texture_amplitude, texture_wavelength;  ///< [m]
  std::optional<double> link_depth, link_gap;                   ///< share, [m]
};

/// What the name of a text begins with when the text is a label.
inline constexpr std::string_view kLabelPrefix = "moontrace:";
bool IsLabelName(const std::string& name);
/// As people name it: GEOM, or GEOM:n for the further ones.
std::string NameOf(const Label& label);

/// Reads one label. `where` stands in messages. Throws InputError naming unknown keys with the
/// nearest valid one.
Label ParseLabel(const std::string& name, const std::string& data, const std::string& where);

}  // namespace moontrace
