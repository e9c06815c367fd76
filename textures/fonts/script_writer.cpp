#include "textures/fonts/script_writer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "textures/base/digest.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"
#include "textures/base/utf8.h"
#include "textures/fonts/script_library.h"
#include "textures/fonts/svg_font_writer.h"
#include "textures/fonts/svg_source.h"

namespace moontrace {
namespace {

constexpr double kTolerance = 0.001;  ///< [em]
constexpr double kRounding = 1e-5;    ///< relative, of measures in the TOML file (six digits)
constexpr int kSamples = 4;           ///< of each piece

/// Points along a stroke by the share of its length, asked in ascending order.
class Walk {
 public:
  explicit Walk(const Stroke& stroke) : stroke_(stroke), length_(Length(stroke.pieces)) {}

  double length() const { return length_; }

  glm::dvec2 At(double share) {
    const double s = share * length_;
    double piece = Length(stroke_.pieces[index_]);
    while (s > before_ + piece && index_ + 1 < stroke_.pieces.size()) {
      before_ += piece;
      piece = Length(stroke_.pieces[++index_]);
    }
    return PointAt(stroke_.pieces[index_], std::clamp(s - before_, 0.0, piece));
  }

 private:
  const Stroke& stroke_;
  double length_ = 0;
  std::size_t index_ = 0;
  double before_ = 0;  ///< length of the pieces before
};

/// Whether `other`, travelled evenly beside `one`, keeps within the tolerance at its samples.
bool Follows(const Stroke& one, const Stroke& other) {
  Walk beside(other);
  const double whole = Length(one.pieces);
  double before = 0;
  for (const Piece& piece : one.pieces) {
    const double length = Length(piece);
    for (int i = 0; i <= kSamples; ++i) {
      const double s = length * i / kSamples;
      const double share = whole > 0 ? std::min(1.0, (before + s) / whole) : 0;
      if (!(glm::length(PointAt(piece, s) - beside.At(share)) <= kTolerance)) return false;
    }
    before += length;
  }
  return true;
}

/// What is drawn: a stroke without pieces is not.
std::vector<const Stroke*> Drawn(const Glyph& glyph) {
  std::vector<const Stroke*> drawn;
  for (const Stroke& stroke : glyph.strokes) {
    if (!stroke.pieces.empty()) drawn.push_back(&stroke);
  }
  return drawn;
}

bool SameStrokes(const Glyph& one, const Glyph& other) {
  const auto same = [](const Stroke* a, const Stroke* b) {
    return a->kind == b->kind && Follows(*a, *b) && Follows(*b, *a);
  };
  const std::vector<const Stroke*> a = Drawn(one), b = Drawn(other);
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

/// What differs about a glyph, if anything.
std::optional<std::string> GlyphDifference(const Glyph& one, const Glyph& other) {
  const std::string sign = "sign '" + Shown(one.name) + "' would come back ";
  if (other.name != one.name) return sign + "as '" + Shown(other.name) + "'";
  if (!(std::abs(other.advance - one.advance) <= kTolerance)) return sign + "wider or narrower";
  if (!SameStrokes(one, other)) return sign + "with other strokes";
  return std::nullopt;
}

bool SameContraction(const Contraction& a, const Contraction& b) {
  return std::tie(a.print, a.signs, a.grade, a.where) ==
         std::tie(b.print, b.signs, b.grade, b.where);
}

bool Near(double a, double b) { return std::abs(a - b) <= kRounding * std::abs(a); }

/// What differs beside the glyphs, if anything.
std::optional<std::string> RulesDifference(const Script& one, const Script& other) {
  if (other.signs != one.signs) return "other characters would have a sign";
  const auto words = [](const Script& s) { return std::tie(s.title, s.author, s.licence); };
  if (words(other) != words(one)) return "title, author or licence would come back otherwise";
  const auto rules = [](const Script& s) {
    return std::tie(s.digits, s.numeral_sign, s.folds, s.forms, s.grades, s.protect_mark,
                    s.braille_tables);
  };
  const bool same_contractions =
      std::equal(one.contractions.begin(), one.contractions.end(), other.contractions.begin(),
                 other.contractions.end(), SameContraction);
  if (rules(other) != rules(one) || !same_contractions)
    return "its rules would come back otherwise";
  const bool same_measures = Near(one.stroke_width, other.stroke_width) &&
                             Near(one.space_advance, other.space_advance) &&
                             Near(one.size, other.size) && Near(one.depth, other.depth) &&
                             Near(one.line_pitch, other.line_pitch);
  if (!same_measures) return "its measures would come back otherwise";
  return std::nullopt;
}

std::optional<std::string> Difference(const Script& one, const Script& other) {
  if (other.glyphs.size() != one.glyphs.size()) {
    return std::to_string(other.glyphs.size()) + " of " + std::to_string(one.glyphs.size()) +
           " signs would come back";
  }
  for (std::size_t i = 0; i < one.glyphs.size(); ++i) {
    std::optional<std::string> difference = GlyphDifference(one.glyphs[i], other.glyphs[i]);
    if (difference) return difference;
  }
  return RulesDifference(one, other);
}

// What stands before a text's digest in the comment at its end.
constexpr std::string_view kSeal = "Digest of all above, as moontrace script convert wrote it: ";

/// The text with a last line that holds its digest.
std::string Sealed(const std::string& text, std::string_view begin, std::string_view end) {
  const std::string digest = ToHex(DigestOf(text));
  return std::string(text).append(begin).append(kSeal).append(digest).append(end) + "\n";
}

bool EndsInItsSeal(std::string_view text) {
  const std::size_t seal = text.rfind(kSeal);
  if (seal == std::string_view::npos) return false;
  const std::string above(text.substr(0, text.rfind('\n', seal) + 1));
  return text == Sealed(above, "<!-- ", " -->") || text == Sealed(above, "# ", "");
}

}  // namespace

bool IsAsWritten(const std::string& path) {
  try {
    return EndsInItsSeal(ReadTextFile(path, kMaxSvgBytes));
  } catch (const InputError&) {
    return false;
  }
}

WrittenScript WriteScript(const Script& script, const std::string& svg_name) {
  WrittenScript written{Sealed(WriteSvgFont(script), "<!-- ", " -->"),
                        Sealed(WriteRules(script), "# ", "")};
  const std::string toml_name = std::filesystem::path(svg_name).replace_extension(".toml").string();
  if (written.toml.size() > kMaxRulesBytes) {
    throw InputError(toml_name + ": its rules would fill more than 4 MB");
  }
  const Script again = ParseScript(written.svg, svg_name, written.toml, toml_name);
  if (const std::optional<std::string> difference = Difference(script, again)) {
    throw InputError(svg_name + ": " + *difference);
  }
  return written;
}

}  // namespace moontrace
