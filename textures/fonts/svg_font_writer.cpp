#include "textures/fonts/svg_font_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/vector_int2_sized.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <string_view>

#include "textures/base/overload.h"
#include "textures/base/utf8.h"
#include "textures/base/xml_text.h"
#include "textures/fonts/glyph_name.h"

namespace moontrace {
namespace {

constexpr double kUnits = 1000;      ///< of one em
constexpr double kDecimals = 10000;  ///< of one unit, as numbers are rounded
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

/// Text for an attribute; control characters, which XML 1.0 has not, are left out.
std::string Escaped(std::string text) {
  std::erase_if(text, [](char c) { return static_cast<unsigned char>(c) < 0x20U; });
  return EscapedXml(text);
}

/// A path's text, written compactly: what goes on from the place before is written relative to it,
/// a letter only where the command changes.
class PathText {
 public:
  /// Begins a subpath.
  void MoveTo(glm::dvec2 p_em) { Command('M', Rounded(p_em), ""); }

  /// `home`: the piece ends where the subpath began, and is written so that it does so for readers
  /// that add up with less care.
  void Add(const Piece& piece, bool home) {
    std::visit(Overload{[&](const Line& line) { LineTo(line.to, home); },
                        [&](const Arc& arc) { ArcTo(arc, home); }},
               piece);
  }

  void Close() {
    text_ += 'Z';
    command_ = 'Z';
  }

  std::string Take() { return std::move(text_); }

 private:
  /// In units of the last decimal.
  using Place = glm::i64vec2;
  static Place Rounded(glm::dvec2 p_em) {
    return {std::llround(kUnits * kDecimals * p_em.x), std::llround(kUnits * kDecimals * p_em.y)};
  }

  void LineTo(glm::dvec2 to_em, bool home) { Command(home ? 'L' : 'l', Rounded(to_em), ""); }

  void ArcTo(const Arc& arc, bool home) {
    const bool flat = arc.radius > kGreatestRadius;
    // a chord lies r (1 - cos(sweep / 2)) below its arc, about r sweep^2 / 8
    const double longest = flat ? std::sqrt(8 * kChordHeight / arc.radius) : kLongestArc;
    const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / longest)));
    const std::string radius = Number(kUnits * arc.radius);
    const std::string shape = fmt::format("{} {} 0 0 {}", radius, radius, arc.sweep > 0 ? 1 : 0);
    for (int i = 1; i <= parts; ++i) {
      const bool last = home && i == parts;
      const glm::dvec2 to = PointAt(Piece(arc), Length(Piece(arc)) * i / parts);
      if (flat) LineTo(to, last);
      if (!flat) Command(last ? 'A' : 'a', Rounded(to), shape);
    }
  }

  /// `shape`: the numbers before the place that is reached.
  void Command(char command, Place to, const std::string& shape) {
    const bool relative = command == 'l' || command == 'a';
    if (command != command_ || command == 'M') text_ += command;
    Append(shape);
    const Place written = relative ? to - at_ : to;
    Append(Number(static_cast<double>(written.x) / kDecimals));
    Append(Number(static_cast<double>(written.y) / kDecimals));
    command_ = command;
    at_ = to;
  }

  /// A blank parts numbers where no sign does.
  void Append(const std::string& numbers) {
    if (numbers.empty()) return;
    const char before = text_.empty() ? 'M' : text_.back();
    const bool behind_number = (before >= '0' && before <= '9') || before == '.';
    if (behind_number && numbers[0] != '-') text_ += ' ';
    text_ += numbers;
  }

  std::string text_;
  char command_ = '\0';
  Place at_{0, 0};
};

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
  PathText path;
  for (std::size_t i = 0; i < glyph.strokes.size(); ++i) {
    if (glyph.strokes[i].pieces.empty()) continue;
    const bool followed = i + 1 < glyph.strokes.size();
    const bool ring = IsRing(glyph.strokes[i]);
    const Stroke stroke = followed && ring ? Opened(glyph.strokes[i]) : glyph.strokes[i];
    const bool closed = stroke.kind != StrokeKind::kStroke;
    path.MoveTo(StartOf(stroke.pieces.front()));
    for (std::size_t k = 0; k < stroke.pieces.size(); ++k) {
      path.Add(stroke.pieces[k], (closed || ring) && k + 1 == stroke.pieces.size());
    }
    if (closed) path.Close();
  }
  return path.Take();
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
                       FontGlyphName(glyph.name), Number(kUnits * glyph.advance), PathOf(glyph));
  }
  return svg + "</font>\n</defs>\n</svg>\n";
}

std::string WriteRules(const Script& script) {
  std::vector<std::string> grades;
  for (const double grade : script.grades) grades.push_back(fmt::format("{}", grade));
  std::string toml = fmt::format(
      "# Rules of the script whose glyphs are in the SVG font of this name.\n"
      "title = {}\nauthor = {}\nlicence = {}\nstroke_width_em = {:.6g}\nspace_advance_em = {:.6g}\n"
      "grades = [{}]\nem_units = {}\n",
      Quoted(script.title), Quoted(script.author), Quoted(script.licence), script.stroke_width,
      script.space_advance, Joined(grades), Number(kUnits));
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
