#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "textures/fonts/script.h"
#include "textures/typeset/fold.h"
#include "textures/typeset/text_page.h"
#include "textures/typeset/writer.h"

namespace moontrace {

/// Turns folded text into signs by a script's rules.
///
/// Numbers: the numeral sign stands once before each run of digits, and again after anything else,
/// so 3.14 has two. The reference is certain of runs only ("1989", "207"); a repeated sign can be
/// read in one way only. The script itself has no mark for the end of a number: letters a to j
/// that follow a digit directly ("3d") read as digits in Moon, here as on paper, and are noted as
/// doubtful.
///
/// Contractions: at each place the longest group of the grade that fits there. Word means letters,
/// and what has no mark in print (a soft hyphen) does not part them; a group at a word's end needs
/// a letter before it, a part of a word one that has a sign before or behind it. A group written as
/// several signs gives its range to the first, the others have an empty range at its end. The
/// script's protect mark before a group (of any grade) keeps it spelled out and is not shown;
/// anywhere else it is a character like others.
///
/// With taught signs given, a group with a sign that is not taught is spelled out, and a letter,
/// mark or digit that is not taught (a digit needs the numeral sign too) is left out and noted.
/// With kLeftOutMark (left_out.h) among them the words that lack one are left out whole.
class SignWriter : public Writer {
 public:
  /// `only` as in TypeStyle: the signs taught so far; empty = all. Throws InputError: an unknown
  /// grade or form of h (naming the known ones), a rule or a taught sign that names a glyph which
  /// the script lacks.
  SignWriter(const Script& script, double grade, const std::string& h_form,
             const std::vector<std::string>& only = {});

  bool Has(char32_t c) const override { return signs_.count(c) > 0 || digits_.count(c) > 0; }
  void Write(std::string_view text, std::size_t line_number, const std::vector<FoldedChar>& line,
             std::vector<Sign>& signs, Typeset& typeset) const override;

 private:
  struct Group {
    std::u32string print;
    std::vector<std::uint32_t> glyphs;
    Contraction::Where where = Contraction::Where::kAnywhere;
    bool active = false;  // at the grade that is set
  };
  std::uint32_t Glyph(const std::string& name) const;
  void Teach(const std::vector<std::string>& only);
  bool IsTaughtGlyph(std::uint32_t glyph) const { return taught_.empty() || taught_[glyph]; }
  bool IsTaught(char32_t c) const;
  const Group* Match(const std::vector<FoldedChar>& line, std::size_t at, bool active_only) const;
  void WriteGroup(const Group& group, const std::vector<FoldedChar>& line, std::size_t at,
                  std::vector<Sign>& signs) const;

  const Script& script_;
  std::string h_glyph_;  // what the sign "h" is drawn as
  std::unordered_map<char32_t, std::uint32_t> signs_, digits_;
  std::unordered_map<std::uint32_t, char32_t> read_as_;  // glyph -> digit, behind a number
  std::vector<Group> groups_;                            // longest first
  std::vector<bool> taught_;                             // by glyph; empty = all
  std::uint32_t numeral_ = 0;
  std::uint32_t left_out_mark_ = 0;
  bool leaves_out_words_ = false;
};

}  // namespace moontrace
