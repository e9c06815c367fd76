#include "textures/fonts/svg_font_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string_view>

#include "textures/base/overload.h"
#include "textures/base/utf8.h"
#include "textures/base/xml_text.h"

namespace moontrace {
namespace {

constexpr double kUnits = 1000;  ///< of one em
constexpr double kLongestArc = std::numbers::pi / 2 + 1e-9;
constexpr double kGreatestRadius = 99;  ///< [em]; readers refuse numbers beyond 100 em
constexpr double kChordHeight = 1e-4;   ///< [em] of a flat arc over the lines written for it

/// Four decimals at most, no needless zeros, no "-0".
std::string Number(double value) {
  std::string text = fmt::format("{:.4f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string Point(glm::dvec2 p_em) {
  return fmt::format("{} {}", Number(kUnits * p_em.x), Number(kUnits * p_em.y));
}

/// Text for an attribute; control characters, which XML 1.0 has not, are left out.
std::string Escaped(std::string text) {
  std::erase_if(text, [](char c) { return static_cast<unsigned char>(c) < 0x20U; });
  return EscapedXml(text);
}

void AppendArc(const Arc& arc, std::string& path) {
  const bool flat = arc.radius > kGreatestRadius;
  // a chord lies r (1 - cos(sweep / 2)) below its arc, about r sweep^2 / 8
  const double longest = flat ? std::sqrt(8 * kChordHeight / arc.radius) : kLongestArc;
  const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / longest)));
  for (int i = 1; i <= parts; ++i) {
    const double angle = arc.start + arc.sweep * i / parts;
    const glm::dvec2 to = arc.center + arc.radius * glm::dvec2(std::cos(angle), std::sin(angle));
    if (flat) {
      path.append(" L").append(Point(to));
      continue;
    }
    const std::string radius = Number(kUnits * arc.radius);
    path += fmt::format(" A{} {} 0 0 {} {}", radius, radius, arc.sweep > 0 ? 1 : 0, Point(to));
  }
}

void AppendPiece(const Piece& piece, std::string& path) {
  std::visit(Overload{[&path](const Line& line) { path.append(" L").append(Point(line.to)); },
                      [&path](const Arc& arc) { AppendArc(arc, path); }},
             piece);
}

std::string PathOf(const Stroke& stroke) {
  std::string path = "M";
  path.append(Point(StartOf(stroke.pieces.front())));
  for (const Piece& piece : stroke.pieces) AppendPiece(piece, path);
  if (stroke.kind != StrokeKind::kStroke) path.append(" Z");
  return path;
}

bool IsRing(const Stroke& stroke) {
  return stroke.kind == StrokeKind::kStroke &&
         glm::length(EndOf(stroke.pieces.back()) - StartOf(stroke.pieces.front())) < 1e-6;
}

/// A ring that stops a hair before its start.
Stroke Opened(Stroke ring) {
  constexpr double kHair = 1e-6;  // [em]
  std::visit(Overload{
                 [](Line& line) { line.to = PointAt(line, Length(line) - kHair); },
                 [](Arc& arc) { arc.sweep -= std::copysign(kHair / arc.radius, arc.sweep); },
             },
             ring.pieces.back());
  return ring;
}

/// All strokes in one path, in writing order. fontforge closes a ring that another subpath follows,
/// so such a ring ends a hair short.
std::string PathOf(const Glyph& glyph) {
  std::string path;
  for (std::size_t i = 0; i < glyph.strokes.size(); ++i) {
    const Stroke& stroke = glyph.strokes[i];
    if (stroke.pieces.empty()) continue;
    const bool followed = i + 1 < glyph.strokes.size();
    path.append(path.empty() ? "" : " ");
    path.append(PathOf(followed && IsRing(stroke) ? Opened(stroke) : stroke));
  }
  return path;
}

/// TOML's basic string.
std::string Quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      result += fmt::format("\\u{:04X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    } else {
      result += c;
    }
  }
  return result + "\"";
}

/// The character that the font itself binds to a glyph: the first, or 0.
std::map<std::string, char32_t> CharactersOf(const Script& script) {
  std::map<std::string, char32_t> characters;
  for (const auto& [character, glyph] : script.signs) characters.emplace(glyph, character);
  return characters;
}

const char* WhereWord(Contraction::Where where) {
  switch (where) {
    case Contraction::Where::kAnywhere:
      return "anywhere";
    case Contraction::Where::kWholeWord:
      return "whole-word";
    case Contraction::Where::kPartOfWord:
      return "part-of-word";
    case Contraction::Where::kWordEnd:
      return "word-end";
  }
  return "anywhere";
}

std::string Joined(const std::vector<std::string>& parts) {
  std::string result;
  for (const std::string& part : parts) result.append(result.empty() ? "" : ", ").append(part);
  return result;
}

void AppendOlderPunctuation(const OlderPunctuation& older, std::string& toml) {
  if (older.short_stop == 0) return;
  std::vector<std::string> serves, abbreviations;
  for (const char32_t mark : older.serves) serves.push_back(Quoted(ToUtf8(mark)));
  for (const std::string& word : older.abbreviations) abbreviations.push_back(Quoted(word));
  toml += fmt::format("\n[older_punctuation]\nshort_stop = {}\nserves = [{}]\n",
                      Quoted(ToUtf8(older.short_stop)), Joined(serves));
  toml += fmt::format("abbreviations = [{}]\n", Joined(abbreviations));
}

void AppendMaps(const Script& script, std::string& toml) {
  const std::map<std::string, char32_t> in_font = CharactersOf(script);
  std::string signs, folds;
  for (const auto& [character, glyph] : script.signs) {
    if (in_font.at(glyph) != character) {
      signs += fmt::format("{} = {}\n", Quoted(ToUtf8(character)), Quoted(glyph));
    }
  }
  for (const auto& [character, text] : script.folds) {
    folds += fmt::format("{} = {}\n", Quoted(ToUtf8(character)), Quoted(text));
  }
  if (!signs.empty()) toml += "\n[signs]\n" + signs;
  if (!folds.empty()) toml += "\n[folds]\n" + folds;
  if (!script.digits.empty()) {
    std::vector<std::string> digits;
    for (const auto& [digit, glyph] : script.digits) {
      digits.push_back(ToUtf8(digit) + " = " + Quoted(glyph));
    }
    toml += fmt::format("\n[numerals]\nsign = {}\ndigits = {{ {} }}\n", Quoted(script.numeral_sign),
                        Joined(digits));
  }
  AppendOlderPunctuation(script.older_punctuation, toml);
  for (const auto& [letter, forms] : script.forms) {
    toml += fmt::format("\n[forms.{}]\n", Quoted(letter));
    for (const auto& [form, glyph] : forms) {
      toml += fmt::format("{} = {}\n", Quoted(form), Quoted(glyph));
    }
  }
}

}  // namespace

std::string WriteSvgFont(const Script& script) {
  const std::map<std::string, char32_t> characters = CharactersOf(script);
  Box ink;
  for (const Glyph& glyph : script.glyphs) {
    for (const Stroke& stroke : glyph.strokes) {
      for (const Piece& piece : stroke.pieces) Include(ink, BoundsOf(piece));
    }
  }
  std::string svg = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\">\n"
      "<metadata>{}, by {}. {}. Rules are in the TOML file of this name.</metadata>\n"
      "<defs>\n<font id=\"{}\" horiz-adv-x=\"{}\">\n"
      "<font-face font-family=\"{}\" units-per-em=\"1000\" cap-height=\"1000\" ascent=\"{}\" "
      "descent=\"{}\"/>\n",
      Escaped(script.title), Escaped(script.author), Escaped(script.licence), Escaped(script.name),
      Number(kUnits * script.space_advance), Escaped(script.title),
      Number(std::max(kUnits, std::ceil(kUnits * ink.max.y))),
      Number(std::min(0.0, std::floor(kUnits * ink.min.y))));
  for (const Glyph& glyph : script.glyphs) {
    const auto character = characters.find(glyph.name);
    const std::string unicode =
        character == characters.end()
            ? ""
            : fmt::format(" unicode=\"{}\"", Escaped(ToUtf8(character->second)));
    svg += fmt::format("<glyph{} glyph-name=\"{}\" horiz-adv-x=\"{}\"\n  d=\"{}\"/>\n", unicode,
                       Escaped(glyph.name), Number(kUnits * glyph.advance), PathOf(glyph));
  }
  return svg + "</font>\n</defs>\n</svg>\n";
}

std::string WriteRules(const Script& script) {
  std::vector<std::string> grades;
  for (const double grade : script.grades) grades.push_back(fmt::format("{}", grade));
  std::string toml = fmt::format(
      "# Rules of the script whose glyphs are in the SVG font of this name.\n"
      "title = {}\nauthor = {}\nlicence = {}\nstroke_width_em = {:.6g}\nspace_advance_em = {:.6g}\n"
      "grades = [{}]\n",
      Quoted(script.title), Quoted(script.author), Quoted(script.licence), script.stroke_width,
      script.space_advance, Joined(grades));
  toml += fmt::format("size_mm = {:.6g}\nline_pitch_em = {:.6g}\n", 1000 * script.size,
                      script.line_pitch);
  if (script.depth > 0) toml += fmt::format("depth_em = {:.6g}\n", script.depth);
  if (script.protect_mark != 0) {
    toml += "protect_mark = " + Quoted(ToUtf8(script.protect_mark)) + "\n";
  }
  AppendMaps(script, toml);
  for (const auto& [grade, table] : script.braille_tables) {
    toml += fmt::format("\n[[braille]]\ngrade = {}\ntable = {}\n", grade, Quoted(table));
  }
  for (const Contraction& contraction : script.contractions) {
    std::vector<std::string> signs;
    for (const std::string& sign : contraction.signs) signs.push_back(Quoted(sign));
    toml += fmt::format(
        "\n[[contractions]]\nprint = {}\nsigns = [{}]\ngrade = {}\nwhere = \"{}\"\n",
        Quoted(contraction.print), Joined(signs), contraction.grade, WhereWord(contraction.where));
  }
  return toml;
}

void JoinStrokes(Glyph& glyph, double tolerance) {
  std::vector<Stroke> joined;
  for (Stroke& stroke : glyph.strokes) {
    const bool open = stroke.kind == StrokeKind::kStroke && !stroke.pieces.empty();
    if (open && !joined.empty() && joined.back().kind == StrokeKind::kStroke) {
      std::vector<Piece>& before = joined.back().pieces;
      const glm::dvec2 end = EndOf(before.back()), start = StartOf(stroke.pieces.front());
      const bool ring = glm::length(end - StartOf(before.front())) <= tolerance;
      if (!ring && glm::length(end - start) <= tolerance) {
        if (glm::length(end - start) > 1e-9) before.emplace_back(Line{end, start});
        before.insert(before.end(), stroke.pieces.begin(), stroke.pieces.end());
        continue;
      }
    }
    joined.push_back(std::move(stroke));
  }
  glyph.strokes = std::move(joined);
}

}  // namespace moontrace
