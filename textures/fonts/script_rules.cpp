#include "textures/fonts/script_rules.h"

#include <algorithm>
#include <set>
#include <vector>

#include "textures/base/nearest_word.h"
#include "textures/base/text_file.h"
#include "textures/base/toml_reader.h"
#include "textures/base/utf8.h"
#include "textures/fonts/glyph_name.h"
#include "textures/fonts/svg_font.h"

namespace moontrace {
namespace {

using Names = std::set<std::string>;

/// The name of the glyph that stands at `key`, by its own name or as font editors number it
/// ("uni0416"). Fails where there is none.
std::string GlyphNamed(const TomlTable& table, const std::string& key, const std::string& glyph,
                       const Names& names) {
  if (names.count(glyph) != 0) return glyph;
  if (std::string named = CharactersNamed(glyph); names.count(named) != 0) return named;
  const std::string nearest = NearestWord(glyph, {names.begin(), names.end()});
  table.Fail(key, "no glyph '" + OneLine(glyph, 40) + "' in the font; " +
                      (nearest.empty() ? "draw it or correct the name"
                                       : "did you mean '" + OneLine(nearest, 40) + "'?"));
}

char32_t OneCharacter(const TomlTable& table, const std::string& key, const std::string& text) {
  const std::u32string codes = ToCodePoints(text);
  if (codes.size() != 1) {
    table.Fail(key, "'" + OneLine(text, 24) + "' is not one character; give one");
  }
  return codes[0];
}

double Positive(const TomlTable& table, const std::string& key, double most) {
  const double number = table.Number(key);
  if (!(number > 0 && number <= most)) {
    table.Fail(key, "not above 0 and up to " + std::to_string(static_cast<int>(most)) +
                        (key == "size_mm" ? " mm; correct it" : " em; correct it"));
  }
  return number;
}

std::vector<double> ReadGrades(const TomlTable& table) {
  std::vector<double> grades = table.Numbers("grades");
  double before = 0;
  for (const double grade : grades) {
    if (!(grade > before)) table.Fail("grades", "not ascending from above 0; order them");
    before = grade;
  }
  if (grades.empty()) table.Fail("grades", "empty; name one grade at least");
  return grades;
}

void ReadSigns(const TomlTable& table, const Names& names, Script& script) {
  for (const std::string& key : table.Keys()) {
    const std::string glyph = GlyphNamed(table, key, table.String(key), names);
    const auto added = script.signs.emplace(OneCharacter(table, key, key), glyph);
    if (!added.second && added.first->second != glyph) {
      table.Fail(key, "the font binds this character to '" + OneLine(added.first->second, 40) +
                          "'; keep one of the two");
    }
  }
}

void ReadNumerals(const TomlTable& table, const Names& names, Script& script) {
  script.numeral_sign = GlyphNamed(table, "sign", table.String("sign"), names);
  const TomlTable digits = table.Table("digits");
  for (char digit = '0'; digit <= '9'; ++digit) {
    const std::string key(1, digit);
    script.digits[static_cast<char32_t>(digit)] =
        GlyphNamed(digits, key, digits.String(key), names);
  }
  digits.FailUnknown();
  table.FailUnknown();
}

Contraction ReadContraction(const TomlTable& table, const Names& names) {
  Contraction contraction;
  contraction.print = table.String("print");
  if (contraction.print.empty()) table.Fail("print", "empty; give the letters it stands for");
  contraction.signs = table.Strings("signs");
  if (contraction.signs.empty()) table.Fail("signs", "empty; name the glyphs that are written");
  for (std::string& sign : contraction.signs) sign = GlyphNamed(table, "signs", sign, names);
  contraction.grade = table.Number("grade");
  const std::string where = table.String("where", "anywhere");
  if (where == "anywhere") {
    contraction.where = Contraction::Where::kAnywhere;
  } else if (where == "whole-word") {
    contraction.where = Contraction::Where::kWholeWord;
  } else if (where == "part-of-word") {
    contraction.where = Contraction::Where::kPartOfWord;
  } else if (where == "word-end") {
    contraction.where = Contraction::Where::kWordEnd;
  } else {
    table.Fail("where", "'" + OneLine(where, 24) +
                            "' is none of anywhere, whole-word, part-of-word, word-end");
  }
  table.FailUnknown();
  return contraction;
}

void ReadBraille(const TomlTable& table, Script& script) {
  const double grade = table.Number("grade");
  const bool known = std::count(script.grades.begin(), script.grades.end(), grade) > 0;
  if (!known) table.Fail("grade", "not among the grades above; add it there or correct it");
  const std::string name = table.String("table");
  if (name.empty()) table.Fail("table", "empty; name a table of liblouis");
  if (!script.braille_tables.emplace(grade, name).second) {
    table.Fail("grade", "a second table for this grade; keep one");
  }
  table.FailUnknown();
}

// Usual measures that a script may leave to the defaults.
void ReadMeasures(const TomlTable& table, Script& script) {
  if (table.Has("size_mm")) script.size = Positive(table, "size_mm", 1000) / 1000;
  if (table.Has("depth_em")) script.depth = Positive(table, "depth_em", 1);
  if (table.Has("line_pitch_em")) script.line_pitch = Positive(table, "line_pitch_em", 100);
}

void ReadEm(const TomlTable& table, double font_em, Script& script) {
  const double scale = font_em / table.Number("em_units");
  if (!(scale >= 0.1 && scale <= 10)) {
    table.Fail("em_units", "far from the font's own cap-height; give the font's units in one em");
  }
  if (scale == 1) return;
  double reach = 0;
  for (Glyph& glyph : script.glyphs) {
    glyph.advance *= scale;
    reach = std::max(reach, glyph.advance);
    for (Stroke& stroke : glyph.strokes) {
      for (Piece& piece : stroke.pieces) {
        piece = Placed(piece, scale, glm::dvec2(0.0, 0.0));
        const Box box = BoundsOf(piece);
        reach = std::max({reach, box.max.x, box.max.y, -box.min.x, -box.min.y});
      }
    }
  }
  if (reach > kMaxEms) table.Fail("em_units", "by it a glyph reaches beyond 100 em; correct it");
}

void ReadForms(const TomlTable& table, const Names& names, Script& script) {
  for (const std::string& key : table.Keys()) {
    const std::string letter = GlyphNamed(table, key, key, names);
    const TomlTable forms = table.Table(key);
    bool has_default = false;
    for (const std::string& form : forms.Keys()) {
      const std::string glyph = GlyphNamed(forms, form, forms.String(form), names);
      script.forms[letter][form] = glyph;
      has_default = has_default || glyph == letter;
    }
    if (!has_default) {
      table.Fail(key, "no form is the glyph '" + OneLine(letter, 40) + "' itself; name one so");
    }
  }
}

void ReadOlderPunctuation(const TomlTable& table, OlderPunctuation& older) {
  older.short_stop = OneCharacter(table, "short_stop", table.String("short_stop"));
  for (const std::string& mark : table.Strings("serves")) {
    older.serves.insert(OneCharacter(table, "serves", mark));
  }
  for (const std::string& word : table.Strings("abbreviations")) older.abbreviations.insert(word);
  table.FailUnknown();
}

}  // namespace

void ReadRules(std::string_view toml, const std::string& file_name, double font_em,
               Script& script) {
  const TomlTable table = TomlTable::Parse(toml, file_name);
  if (table.Has("em_units")) ReadEm(table, font_em, script);
  Names names;
  for (const Glyph& glyph : script.glyphs) names.insert(glyph.name);
  script.title = table.String("title");
  script.author = table.String("author");
  script.licence = table.String("licence");
  script.stroke_width = Positive(table, "stroke_width_em", 1);
  script.space_advance = Positive(table, "space_advance_em", 100);
  script.grades = ReadGrades(table);
  ReadMeasures(table, script);
  for (const TomlTable& braille : table.Tables("braille")) ReadBraille(braille, script);
  if (table.Has("protect_mark")) {
    script.protect_mark = OneCharacter(table, "protect_mark", table.String("protect_mark"));
  }
  if (table.Has("signs")) ReadSigns(table.Table("signs"), names, script);
  if (table.Has("numerals")) ReadNumerals(table.Table("numerals"), names, script);
  for (const TomlTable& contraction : table.Tables("contractions")) {
    script.contractions.push_back(ReadContraction(contraction, names));
  }
  if (table.Has("folds")) {
    const TomlTable folds = table.Table("folds");
    for (const std::string& key : folds.Keys()) {
      script.folds[OneCharacter(folds, key, key)] = folds.String(key);
    }
  }
  if (table.Has("older_punctuation")) {
    ReadOlderPunctuation(table.Table("older_punctuation"), script.older_punctuation);
  }
  if (table.Has("forms")) ReadForms(table.Table("forms"), names, script);
  table.FailUnknown();
}

}  // namespace moontrace
