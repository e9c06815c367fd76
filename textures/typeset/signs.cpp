#include "textures/typeset/signs.h"

#include <fmt/format.h>

#include <algorithm>

#include "textures/base/error.h"
#include "textures/base/nearest_word.h"
#include "textures/base/utf8.h"
#include "textures/typeset/left_out.h"
#include "textures/typeset/line_ends.h"

namespace moontrace {
namespace {

std::string FindForm(const Script& script, const std::string& h_form) {
  if (h_form.empty()) return "h";
  const auto forms = script.forms.find("h");
  if (forms == script.forms.end()) {
    throw InputError(fmt::format("script {} has one form of h only, no '{}': leave the form out",
                                 script.name, Shown(h_form)));
  }
  const auto found = forms->second.find(h_form);
  if (found != forms->second.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& form : forms->second) names.push_back(form.first);
  const std::string nearest = NearestWord(h_form, names);
  throw InputError(fmt::format("script {} has no h '{}': {}choose {}", script.name, Shown(h_form),
                               nearest.empty() ? nearest : "did you mean " + nearest + "? ",
                               fmt::join(names, ", ")));
}

// The neighbours that a reader sees: what has no mark in print is passed over. Null at the ends.
const FoldedChar* Before(const std::vector<FoldedChar>& line, std::size_t at) {
  while (at > 0 && line[at - 1].kind == FoldedChar::Kind::kNothing) --at;
  return at > 0 ? &line[at - 1] : nullptr;
}

const FoldedChar* From(const std::vector<FoldedChar>& line, std::size_t at) {
  while (at < line.size() && line[at].kind == FoldedChar::Kind::kNothing) ++at;
  return at < line.size() ? &line[at] : nullptr;
}

bool IsLetter(const FoldedChar* c) { return c != nullptr && c->letter; }

bool IsWritten(const FoldedChar* c) { return c != nullptr && c->kind == FoldedChar::Kind::kSign; }

// Whether a group may be written between these neighbours.
bool Stands(Contraction::Where where, const FoldedChar* before, const FoldedChar* behind) {
  switch (where) {
    case Contraction::Where::kAnywhere:
      return true;
    case Contraction::Where::kWholeWord:
      return !IsLetter(before) && !IsLetter(behind);
    case Contraction::Where::kPartOfWord:
      return (IsLetter(before) && IsWritten(before)) || (IsLetter(behind) && IsWritten(behind));
    case Contraction::Where::kWordEnd:
      return IsLetter(before) && !IsLetter(behind);
  }
  return false;
}

}  // namespace

SignWriter::SignWriter(const Script& script, double grade, const std::string& h_form,
                       const std::vector<std::string>& only)
    : script_(script), h_glyph_(FindForm(script, h_form)) {
  CheckGrade(script, grade);
  Teach(only);
  for (const auto& sign : script.signs) signs_.emplace(sign.first, Glyph(sign.second));
  for (const auto& digit : script.digits) {
    digits_.emplace(digit.first, Glyph(digit.second));
    read_as_.emplace(Glyph(digit.second), digit.first);
  }
  if (!digits_.empty()) numeral_ = Glyph(script.numeral_sign);
  for (const Contraction& contraction : script.contractions) {
    Group group;
    group.print = ToCodePoints(contraction.print);
    for (const std::string& name : contraction.signs) group.glyphs.push_back(Glyph(name));
    group.where = contraction.where;
    group.active = contraction.grade <= grade;
    for (const std::uint32_t glyph : group.glyphs)
      group.active = group.active && IsTaughtGlyph(glyph);
    if (!group.print.empty() && !group.glyphs.empty()) groups_.push_back(std::move(group));
  }
  std::stable_sort(groups_.begin(), groups_.end(),
                   [](const Group& a, const Group& b) { return a.print.size() > b.print.size(); });
}

void SignWriter::Teach(const std::vector<std::string>& only) {
  if (only.empty()) return;
  taught_.assign(script_.glyphs.size(), false);
  for (const std::string& name : only) taught_[Glyph(name)] = true;
  leaves_out_words_ = LeavesOutWords(only);
  if (leaves_out_words_) left_out_mark_ = Glyph(kLeftOutMark);
}

// Of a character that has a sign; a digit is written with the numeral sign.
bool SignWriter::IsTaught(char32_t c) const {
  const auto digit = digits_.find(c);
  if (digit != digits_.end()) return IsTaughtGlyph(numeral_) && IsTaughtGlyph(digit->second);
  return IsTaughtGlyph(signs_.at(c));
}

std::uint32_t SignWriter::Glyph(const std::string& name) const {
  const std::string& drawn = name == "h" ? h_glyph_ : name;
  const std::size_t index = script_.Find(drawn);
  if (index == Script::npos) {
    throw InputError(
        fmt::format("script {}: its rules name the glyph '{}', its font lacks it: draw it",
                    script_.name, drawn));
  }
  return static_cast<std::uint32_t>(index);
}

const SignWriter::Group* SignWriter::Match(const std::vector<FoldedChar>& line, std::size_t at,
                                           bool active_only) const {
  for (const Group& group : groups_) {
    if (active_only && !group.active) continue;
    const std::size_t end = at + group.print.size();
    if (end > line.size()) continue;
    bool same = true;
    for (std::size_t i = at; i < end && same; ++i) {
      same = line[i].kind == FoldedChar::Kind::kSign && line[i].code == group.print[i - at];
    }
    if (!same) continue;
    if (!active_only || Stands(group.where, Before(line, at), From(line, end))) return &group;
  }
  return nullptr;
}

void SignWriter::WriteGroup(const Group& group, const std::vector<FoldedChar>& line, std::size_t at,
                            std::vector<Sign>& signs) const {
  Sign sign;
  sign.begin = line[at].begin;
  sign.end = line[at + group.print.size() - 1].end;
  for (const std::uint32_t glyph : group.glyphs) {
    sign.glyph = glyph;
    sign.keep_next = sign.bound = true;
    signs.push_back(sign);
    sign.begin = sign.end;
  }
  signs.back().keep_next = signs.back().bound = false;
}

void SignWriter::Write(std::string_view text, std::size_t line_number,
                       const std::vector<FoldedChar>& line, std::vector<Sign>& signs,
                       Typeset& typeset) const {
  using Kind = FoldedChar::Kind;
  bool in_number = false, in_word = false;  // in_word: a sign other than a hyphen since the space
  bool reads_on = false;                    // the next sign reads as a digit if it can
  std::size_t spelled = line.size();        // where the protect mark forbids a group
  const std::vector<LineEnd> ends = LineEndsOf(line);
  const std::size_t begin = signs.size();
  WrittenLine as{std::vector<std::size_t>(line.size()), std::vector<bool>(line.size())};
  for (std::size_t at = 0; at < line.size();) {
    const FoldedChar& c = line[at];
    as.first[at] = signs.size();
    if (script_.protect_mark != 0 && c.code == script_.protect_mark && Match(line, at + 1, false)) {
      spelled = ++at;
      continue;
    }
    const Group* group = at == spelled ? nullptr : Match(line, at, true);
    const std::size_t length = group ? group->print.size() : 1;
    for (std::size_t i = at; i < at + length; ++i) {
      as.first[i] = signs.size();
      if (line[i].changed && line[i].kind != Kind::kMissing) {
        Note(typeset.folded, typeset.folded_count, text, line_number, line[i], Became(line, i));
      }
    }
    const auto digit = digits_.find(c.code);
    const bool taught = group || c.kind != Kind::kSign || IsTaught(c.code);
    const bool is_digit = taught && !group && c.kind == Kind::kSign && digit != digits_.end();
    const std::size_t written = signs.size();
    if (group) {
      WriteGroup(*group, line, at, signs);
    } else if (!taught) {
      Note(typeset.untaught, typeset.untaught_count, text, line_number, c, {});
      as.untaught[at] = true;
    } else if (is_digit) {
      const bool goes_on = in_number && c.apart == line[at - 1].apart;
      if (!goes_on) {
        signs.push_back({numeral_, c.begin, c.begin, false, false, true});
        signs.back().bound = true;
      }
      signs.push_back({digit->second, c.begin, c.end});
      signs.back().in_number = goes_on;
    } else if (c.kind == Kind::kSign) {
      signs.push_back({signs_.at(c.code), c.begin, c.end});
      const auto read_as = read_as_.find(signs.back().glyph);
      reads_on = reads_on && read_as != read_as_.end();
      if (reads_on) {
        Note(typeset.doubtful, typeset.doubtful_count, text, line_number, c,
             ToUtf8(read_as->second));
      }
      const bool hyphen_behind = at + 1 < line.size() && line[at + 1].code == U'-';
      signs.back().break_after = c.code == U'-' && in_word && !hyphen_behind;
    } else if (c.kind == Kind::kSpace) {
      signs.push_back({0, c.begin, c.end, true});
    } else if (c.kind == Kind::kMissing) {
      Note(typeset.missing, typeset.missing_count, text, line_number, c, {});
    }
    if (signs.size() > written) {
      const LineEnd& end = ends[at + length - 1];
      signs.back().keep_next = end.keep_next;
      signs.back().bound = end.bound;
      signs.back().mark = end.mark;
      signs.back().break_after = signs.back().break_after || end.may_end;
    }
    if (group || c.kind == Kind::kSpace) reads_on = false;
    if (is_digit) reads_on = true;
    in_number = is_digit;
    in_word = c.kind != Kind::kSpace && (in_word || (c.kind == Kind::kSign && c.code != U'-'));
    at += length;
  }
  if (leaves_out_words_) LeaveOutWords(line, as, left_out_mark_, begin, signs);
}

}  // namespace moontrace
