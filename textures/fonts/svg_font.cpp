#include "textures/fonts/svg_font.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <functional>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <utility>

#include "textures/base/error.h"
#include "textures/base/text_file.h"
#include "textures/base/utf8.h"
#include "textures/fonts/character_script.h"
#include "textures/fonts/glyph_name.h"
#include "textures/fonts/svg_path.h"
#include "textures/fonts/svg_shapes.h"
#include "textures/fonts/svg_source.h"

namespace moontrace {
namespace {

/// Bytes of a file for each command and piece beyond those that every file may have: no path
/// without <use> writes more of them.
constexpr std::size_t kBytesOfCommand = 4;
constexpr double kUnitsPerEm = 1000;  ///< where a font states none: SVG 1.1, 20.8.3
constexpr double kTolerance = 0.001;  ///< [em]
constexpr double kAgreement = 0.02;   ///< of a letter's height with the figure stated, relative

std::string Quoted(std::string_view text) { return fmt::format("'{}'", OneLine(text, 40)); }

bool IsEm(double units) { return units >= 1e-3 && units <= 1e6; }

/// Whether a figure of the font's face agrees with what is drawn.
bool Agree(double stated, double drawn) { return std::abs(drawn - stated) <= kAgreement * drawn; }

class FontReader {
 public:
  FontReader(std::string_view svg, const std::string& file_name, SvgFontKind kind)
      : source_(svg, file_name), foreign_(kind == SvgFontKind::kForeign) {
    limits_.commands = std::max(limits_.commands, svg.size() / kBytesOfCommand);
    limits_.pieces = std::max(limits_.pieces, svg.size() / kBytesOfCommand);
  }

  SvgFont Read() {
    const pugi::xml_node font = FindFont();
    em_ = StatedEm(font);
    if (foreign_) em_ = EmByLetters(font, em_);
    out_.em = em_;
    out_.family = font.child("font-face").attribute("font-family").value();
    if (out_.family.empty()) out_.family = font.attribute("id").value();
    out_.metadata = source_.root().child("metadata").text().get();
    limits_.tolerance = kTolerance * em_;
    limits_.greatest = kMaxEms * em_;
    for (const pugi::xml_node node : font.children("glyph")) written_.insert(WrittenName(node));
    for (const pugi::xml_node node : font.children("glyph")) {
      if (out_.glyphs.size() == kMostCharacters) {
        source_.Fail(node, fmt::format("more than {} glyphs; use fewer", kMostCharacters));
      }
      ReadGlyph(font, node);
    }
    if (out_.glyphs.empty() && foreign_) {
      source_.Fail(font, "a font in which nothing is drawn; give one with open paths");
    }
    if (out_.glyphs.empty()) source_.Fail(font, "a font without glyphs; draw one <glyph> at least");
    return std::move(out_);
  }

 private:
  pugi::xml_node FindFont() const {
    const pugi::xml_node root = source_.root();
    if (std::strcmp(root.name(), "svg") != 0) {
      source_.Fail(root, "the document is <" + OneLine(root.name(), 24) +
                             ">, not <svg>; give an SVG 1.1 font");
    }
    const pugi::xml_node font =
        root.find_node([](pugi::xml_node node) { return std::strcmp(node.name(), "font") == 0; });
    if (!font) {
      source_.Fail(root, "an SVG without a <font>: a drawing, not a script; give an SVG 1.1 font");
    }
    return font;
  }

  /// By the face's figures; notes which one it is.
  double StatedEm(pugi::xml_node font) {
    const pugi::xml_node face = font.child("font-face");
    if (!face) source_.Fail(font, "a font without <font-face>; add one with units-per-em");
    std::optional<double> em;
    for (const char* figure : {"cap-height", "ascent", "units-per-em"}) {
      if (em.value_or(0) != 0) break;
      if (!foreign_ && std::strcmp(figure, "ascent") == 0) continue;
      if (const std::optional<double> number = source_.NumberOf(face, figure)) em = number;
      stated_by_ = figure;
    }
    if (!em && foreign_) em = kUnitsPerEm;
    if (!em) source_.Fail(face, "neither cap-height nor units-per-em; give one of them");
    if (!IsEm(*em)) {
      source_.Fail(face, "cap-height or units-per-em outside 0.001 to 1000000; use 1000");
    }
    return *em;
  }

  /// How far the first drawn glyph of a character reaches above the base line [units]; 0 where
  /// there is none.
  double TopOf(pugi::xml_node font, char32_t character) {
    const std::string wanted = ToUtf8(character);
    const pugi::xml_node node = font.find_child([&wanted](pugi::xml_node child) {
      return std::strcmp(child.name(), "glyph") == 0 &&
             wanted == child.attribute("unicode").value();
    });
    double top = 0;
    if (!node) return top;
    for (const Stroke& stroke : shapes_.Of(node)) {
      for (const Piece& piece : stroke.pieces) top = std::max(top, BoundsOf(piece).max.y);
    }
    return top;
  }

  /// The em as svg_font.h says: what the font states, or what its letters show.
  double EmByLetters(pugi::xml_node font, double stated) {
    double units = source_.NumberOf(font.child("font-face"), "units-per-em").value_or(stated);
    if (!IsEm(units)) units = stated;
    limits_.greatest = kMaxEms * std::max(stated, units);
    limits_.tolerance = kTolerance * stated;
    const auto is_letter = [units](double top) {
      return IsEm(top) && top >= 0.1 * units && top <= 3 * units;
    };
    for (const char32_t capital : std::u32string_view(U"HEFIKLMNTUVWXYZ")) {
      const double top = TopOf(font, capital);
      if (!is_letter(top)) continue;
      if (Agree(stated, top)) return stated;
      const std::string letter = ToUtf8(capital);
      out_.remark = fmt::format("its {} is {:.6g}, but its {} is {:.6g} high; sized by {}.",
                                stated_by_, stated, letter, top, letter);
      return top;
    }
    const double x = TopOf(font, U'x');
    return is_letter(x) ? EmByX(font.child("font-face"), stated, x) : stated;
  }

  double EmByX(pugi::xml_node face, double stated, double x) {
    const double x_height = source_.NumberOf(face, "x-height").value_or(0);
    const double em = stated * x / x_height;
    const bool states_both = x_height > 0 && source_.NumberOf(face, "cap-height").value_or(0) > 0;
    if (!states_both || !IsEm(em) || Agree(x_height, x)) return stated;
    out_.remark =
        fmt::format("its x-height is {:.6g}, but its x is {:.6g} high; sized by x.", x_height, x);
    return em;
  }

  /// As the file has it.
  static std::string_view WrittenName(pugi::xml_node node) {
    const std::string_view name = node.attribute("glyph-name").value();
    return name.empty() ? node.attribute("unicode").value() : name;
  }

  /// By its characters where the file only numbers them, unless another glyph is called that.
  std::string NameOf(pugi::xml_node node) const {
    const std::string_view written = WrittenName(node);
    std::string characters = CharactersNamed(written);
    const bool free = !characters.empty() && written_.count(characters) == 0;
    return free ? characters : std::string(written);
  }

  void ReadGlyph(pugi::xml_node font, pugi::xml_node node) {
    const std::string characters = node.attribute("unicode").value();
    Glyph glyph;
    glyph.name = NameOf(node);
    if (glyph.name.empty()) {
      if (foreign_) return;
      source_.Fail(node, "a glyph without glyph-name or unicode; name it");
    }
    glyph.strokes = StrokesOf(node);
    if (characters == " ") out_.space_advance = StepOf(font, node).value_or(0) / em_;
    if (glyph.strokes.empty()) {
      if (foreign_ || characters == " " || characters == "\u00a0") return;
      source_.Fail(node, "glyph " + Quoted(glyph.name) + " has nothing drawn; draw or remove it");
    }
    if (foreign_ && StepOf(font, node).value_or(0) == 0) return;
    Name(node, glyph);
    glyph.advance = AdvanceOf(font, node, glyph.name);
    if (!characters.empty()) Bind(node, characters, glyph.name);
    out_.glyphs.push_back(std::move(glyph));
  }

  /// Makes sure that the name is the glyph's alone.
  void Name(pugi::xml_node node, Glyph& glyph) {
    if (names_.insert(glyph.name).second) return;
    if (!foreign_) {
      source_.Fail(node, "second glyph named " + Quoted(glyph.name) + "; rename or remove one");
    }
    std::size_t& count = copies_[glyph.name];
    const std::string name = glyph.name;
    do {
      glyph.name = fmt::format("{}#{}", name, ++count + 1);
    } while (!names_.insert(glyph.name).second);
  }

  std::optional<double> StepOf(pugi::xml_node font, pugi::xml_node node) const {
    const std::optional<double> step = source_.NumberOf(node, "horiz-adv-x");
    return step ? step : source_.NumberOf(font, "horiz-adv-x");
  }

  double AdvanceOf(pugi::xml_node font, pugi::xml_node node, const std::string& name) const {
    const std::optional<double> advance = StepOf(font, node);
    if (!advance) source_.Fail(node, "glyph " + Quoted(name) + " has no horiz-adv-x; give one");
    // what is above zero as written can still vanish in ems
    if (!(*advance / em_ > 0 && *advance <= limits_.greatest)) {
      source_.Fail(node, "horiz-adv-x of glyph " + Quoted(name) +
                             " outside 0 to 100 em; give the step to the next letter");
    }
    return *advance / em_;
  }

  void Bind(pugi::xml_node node, const std::string& characters, const std::string& name) {
    const std::u32string codes = ToCodePoints(characters);
    const bool one = codes.size() == 1 && ToUtf8(codes[0]) == characters;
    if (foreign_) {
      if (one) out_.characters.emplace(codes[0], name);
      if (!one) out_.groups.emplace(characters, name);
      return;
    }
    if (!one) {
      source_.Fail(node, node.attribute("unicode"), 0,
                   "unicode is " + Quoted(characters) +
                       "; give one character, and put groups of letters into the TOML file");
    }
    if (!out_.characters.emplace(codes[0], name).second) {
      source_.Fail(node, node.attribute("unicode"), 0,
                   "second glyph for " + Quoted(characters) + "; keep one");
    }
  }

  std::vector<Stroke> StrokesOf(pugi::xml_node node) {
    std::vector<Stroke> strokes = shapes_.Of(node);
    for (Stroke& stroke : strokes) {
      for (Piece& piece : stroke.pieces) piece = Placed(piece, 1 / em_, glm::dvec2(0.0, 0.0));
    }
    // Filled areas are not written, so a font may draw them first.
    std::stable_partition(strokes.begin(), strokes.end(),
                          [](const Stroke& stroke) { return stroke.kind != StrokeKind::kFill; });
    return strokes;
  }

  SvgSource source_;
  bool foreign_ = false;
  double em_ = 1000;
  const char* stated_by_ = "";  ///< the face's figure that states the em
  PathLimits limits_;
  SvgShapes shapes_{source_, limits_};
  std::set<std::string_view, std::less<>> written_;  ///< names as the file has them
  std::set<std::string> names_;
  std::map<std::string, std::size_t> copies_;  ///< by name: how many have been renamed
  SvgFont out_;
};

}  // namespace

SvgFont ParseSvgFont(std::string_view svg, const std::string& file_name, SvgFontKind kind) {
  return FontReader(svg, file_name, kind).Read();
}

}  // namespace moontrace
