#include "textures/svg_font.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numbers>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <utility>

#include "textures/error.h"
#include "textures/fold.h"
#include "textures/svg_path.h"
#include "textures/text_file.h"

namespace moontrace {
namespace {

constexpr std::size_t kMaxGlyphs = 10000;
constexpr double kMaxEms = 100;
constexpr double kTolerance = 0.001;  ///< [em]

/// The document, parsed in place, so that every value can be traced to its byte in the file.
class Source {
 public:
  Source(std::string_view svg, const std::string& file_name)
      : text_(svg), buffer_(svg), file_(file_name) {
    if (svg.size() > kMaxSvgBytes) {
      throw InputError(file_name + ": holds more than 8 MB; simplify the font");
    }
    const pugi::xml_parse_result result = document_.load_buffer_inplace(
        buffer_.data(), buffer_.size(), pugi::parse_escapes, pugi::encoding_utf8);
    if (result.status == pugi::status_no_document_element) {
      Fail(0, "no XML in this file; give an SVG 1.1 font");
    }
    if (!result) {
      Fail(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)),
           std::string("broken XML: ") + result.description() + "; give an SVG 1.1 font");
    }
  }

  pugi::xml_node root() const { return document_.document_element(); }

  [[noreturn]] void Fail(std::size_t offset, const std::string& problem) const {
    const TextPlace place = PlaceOf(text_, offset);
    throw InputError(file_ + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) +
                     ": " + problem);
  }
  [[noreturn]] void Fail(pugi::xml_node node, const std::string& problem) const {
    // pugixml gives the place of the name, behind the "<".
    Fail(static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug() - 1, 0)), problem);
  }
  /// `inside` counts bytes from the value's first.
  [[noreturn]] void Fail(pugi::xml_node node, pugi::xml_attribute attribute, std::size_t inside,
                         const std::string& problem) const {
    const std::ptrdiff_t start = attribute.value() - buffer_.data();
    if (start < 0 || static_cast<std::size_t>(start) > buffer_.size()) Fail(node, problem);
    Fail(static_cast<std::size_t>(start) + inside, problem);
  }

 private:
  std::string_view text_;
  std::string buffer_;
  std::string file_;
  pugi::xml_document document_;
};

std::string Quoted(std::string_view text) { return fmt::format("'{}'", OneLine(text, 40)); }

/// The attribute as a finite number; nothing when it is absent.
std::optional<double> NumberOf(const Source& source, pugi::xml_node node, const char* name) {
  const pugi::xml_attribute attribute = node.attribute(name);
  if (!attribute) return std::nullopt;
  const std::string_view text = attribute.value();
  std::size_t offset = 0;
  const std::optional<double> number = ReadSvgNumber(text, offset);
  if (!number || offset != text.size()) {
    source.Fail(node, attribute, 0,
                std::string(name) + " is " + Quoted(text) + "; give a finite number");
  }
  return number;
}

StrokeKind KindOf(const Subpath& subpath) {
  if (!subpath.closed) return StrokeKind::kStroke;
  const Arc* arc = std::get_if<Arc>(&subpath.pieces.front());
  const bool circle =
      subpath.pieces.size() == 1 && arc != nullptr && std::abs(arc->sweep) >= 2 * std::numbers::pi;
  return circle ? StrokeKind::kDot : StrokeKind::kFill;
}

class FontReader {
 public:
  FontReader(std::string_view svg, const std::string& file_name) : source_(svg, file_name) {}

  SvgFont Read() {
    const pugi::xml_node font = FindFont();
    em_ = EmOf(font);
    limits_.tolerance = kTolerance * em_;
    limits_.greatest = kMaxEms * em_;
    for (const pugi::xml_node node : font.children("glyph")) {
      if (out_.glyphs.size() == kMaxGlyphs) source_.Fail(node, "more than 10000 glyphs; use fewer");
      ReadGlyph(font, node);
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

  double EmOf(pugi::xml_node font) const {
    const pugi::xml_node face = font.child("font-face");
    if (!face) source_.Fail(font, "a font without <font-face>; add one with units-per-em");
    std::optional<double> em = NumberOf(source_, face, "cap-height");
    if (!em) em = NumberOf(source_, face, "units-per-em");
    if (!em) source_.Fail(face, "neither cap-height nor units-per-em; give one of them");
    if (!(*em >= 1e-3 && *em <= 1e6)) {
      source_.Fail(face, "cap-height or units-per-em outside 0.001 to 1000000; use 1000");
    }
    return *em;
  }

  void ReadGlyph(pugi::xml_node font, pugi::xml_node node) {
    const std::string characters = node.attribute("unicode").value();
    Glyph glyph;
    glyph.name = node.attribute("glyph-name").value();
    if (glyph.name.empty()) glyph.name = characters;
    if (glyph.name.empty()) source_.Fail(node, "a glyph without glyph-name or unicode; name it");
    glyph.strokes = StrokesOf(node);
    if (glyph.strokes.empty()) {
      if (characters == " " || characters == "\u00a0") return;
      source_.Fail(node, "glyph " + Quoted(glyph.name) + " has nothing drawn; draw or remove it");
    }
    if (!names_.insert(glyph.name).second) {
      source_.Fail(node, "second glyph named " + Quoted(glyph.name) + "; rename or remove one");
    }
    glyph.advance = AdvanceOf(font, node, glyph.name);
    if (!characters.empty()) Bind(node, characters, glyph.name);
    out_.glyphs.push_back(std::move(glyph));
  }

  double AdvanceOf(pugi::xml_node font, pugi::xml_node node, const std::string& name) const {
    std::optional<double> advance = NumberOf(source_, node, "horiz-adv-x");
    if (!advance) advance = NumberOf(source_, font, "horiz-adv-x");
    if (!advance) source_.Fail(node, "glyph " + Quoted(name) + " has no horiz-adv-x; give one");
    if (!(*advance > 0 && *advance <= limits_.greatest)) {
      source_.Fail(node, "horiz-adv-x of glyph " + Quoted(name) +
                             " outside 0 to 100 em; give the step to the next letter");
    }
    return *advance / em_;
  }

  void Bind(pugi::xml_node node, const std::string& characters, const std::string& name) {
    const std::u32string codes = ToCodePoints(characters);
    if (codes.size() != 1 || ToUtf8(codes[0]) != characters) {
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
    std::vector<Stroke> strokes;
    AppendPath(node, strokes);
    for (const pugi::xml_node child : node.children()) {
      if (child.type() != pugi::node_element) continue;
      const std::string_view name = child.name();
      if (name == "title" || name == "desc" || name == "metadata") continue;
      if (child.attribute("transform")) {
        source_.Fail(child, "a transform is not read; apply it in the editor");
      }
      if (name == "path") {
        AppendPath(child, strokes);
      } else if (name == "circle") {
        Append(Circle(child), strokes);
      } else {
        source_.Fail(child,
                     fmt::format("<{}> in a glyph is not read; convert it to a path in the editor",
                                 OneLine(name, 24)));
      }
    }
    return strokes;
  }

  void AppendPath(pugi::xml_node node, std::vector<Stroke>& strokes) {
    const pugi::xml_attribute path = node.attribute("d");
    try {
      for (const Subpath& subpath : ParseSvgPath(path.value(), limits_)) Append(subpath, strokes);
    } catch (const SvgPathError& error) {
      source_.Fail(node, path, error.offset(), error.what());
    }
  }

  Subpath Circle(pugi::xml_node node) {
    const glm::dvec2 center(NumberOf(source_, node, "cx").value_or(0),
                            NumberOf(source_, node, "cy").value_or(0));
    const double radius = NumberOf(source_, node, "r").value_or(0);
    const double reach = std::max(std::abs(center.x), std::abs(center.y)) + radius;
    if (!(radius > 0 && reach <= limits_.greatest)) {
      source_.Fail(node, "a circle without a radius above 0, or beyond 100 em; correct cx, cy, r");
    }
    if (limits_.commands == 0) source_.Fail(node, "too many path commands; simplify the drawing");
    --limits_.commands;
    return CircleSubpath(center, radius);
  }

  void Append(const Subpath& subpath, std::vector<Stroke>& strokes) const {
    Stroke stroke;
    stroke.kind = KindOf(subpath);
    for (const Piece& piece : subpath.pieces) {
      stroke.pieces.push_back(Placed(piece, 1 / em_, glm::dvec2(0.0, 0.0)));
    }
    strokes.push_back(std::move(stroke));
  }

  Source source_;
  double em_ = 1000;
  PathLimits limits_;
  std::set<std::string> names_;
  SvgFont out_;
};

}  // namespace

SvgFont ParseSvgFont(std::string_view svg, const std::string& file_name) {
  return FontReader(svg, file_name).Read();
}

}  // namespace moontrace
