#include "textures/typeset/braille_writer.h"

#include <fmt/core.h>

#include "textures/base/error.h"

namespace moontrace {
namespace {

using Kind = FoldedChar::Kind;

constexpr char32_t kFirstCell = 0x2800;  // Unicode's Braille patterns
constexpr char32_t kSoftHyphen = 0xAD;   // tables write a hyphen, but print has no mark there
constexpr std::uint32_t kNoGlyph = ~std::uint32_t{0};

std::uint32_t GlyphOf(const Script& script, char32_t c) {
  const auto sign = script.signs.find(c);
  const std::size_t glyph = sign == script.signs.end() ? Script::npos : script.Find(sign->second);
  return glyph == Script::npos ? kNoGlyph : static_cast<std::uint32_t>(glyph);
}

// Whether the cell ends in a hyphen that parts two halves of a word.
bool MayBreak(const std::vector<FoldedChar>& run, std::size_t begin, std::size_t end) {
  if (begin == end || run[end - 1].code != U'-' || begin == 0 || end >= run.size()) return false;
  return run[begin - 1].letter && run[end].letter;
}

}  // namespace

std::string BrailleTableOf(const Script& script, double grade, const std::string& table) {
  if (!table.empty()) return table;
  CheckGrade(script, grade);
  const auto found = script.braille_tables.find(grade);
  if (found == script.braille_tables.end()) {
    throw InputError(fmt::format("script {} names no Braille table for grade {}: name one by table",
                                 script.name, grade));
  }
  return found->second;
}

BrailleWriter::BrailleWriter(const Script& script, double grade, const std::string& table)
    : script_(script), table_(BrailleTableOf(script, grade, table)) {
  for (std::size_t dots = 0; dots < cells_.size(); ++dots) {
    cells_[dots] = GlyphOf(script, kFirstCell + static_cast<char32_t>(dots));
  }
}

bool BrailleWriter::Has(char32_t c) const {
  return c != kSoftHyphen && (table_.Has(c) || script_.signs.count(c) > 0);
}

// `ends` are those of the run's characters.
void BrailleWriter::WriteRun(const std::vector<FoldedChar>& run, const std::vector<LineEnd>& ends,
                             std::vector<Sign>& signs) const {
  std::u32string characters;
  for (const FoldedChar& c : run) characters += c.code;
  for (const BrailleCell& cell : table_.Translate(characters)) {
    const bool stands = cell.begin < cell.end;
    Sign sign;
    sign.begin = run[std::min<std::size_t>(cell.begin, run.size() - 1)].begin;
    sign.end = stands ? run[cell.end - 1].end : sign.begin;
    if (!signs.empty() && sign.begin < signs.back().end) sign.begin = signs.back().end;
    sign.end = std::max(sign.begin, sign.end);
    sign.space = cell.dots == 0;
    sign.glyph = sign.space ? 0 : cells_[cell.dots];
    if (sign.glyph == kNoGlyph) {
      throw InputError(fmt::format("script {}: its font lacks the cell U+{:04X}: draw it",
                                   script_.name, 0x2800 + cell.dots));
    }
    // a blank that a table writes beside a mark ends a line where the mark may
    const bool blank = sign.space && cell.end > 0;
    const LineEnd end = stands || blank ? ends[cell.end - 1] : LineEnd{!sign.space, !sign.space};
    sign.keep_next = end.keep_next;
    sign.bound = end.bound;
    sign.mark = end.mark;
    sign.break_after = MayBreak(run, cell.begin, cell.end) || end.may_end;
    signs.push_back(sign);
  }
}

void BrailleWriter::Write(std::string_view text, std::size_t line_number,
                          const std::vector<FoldedChar>& line, std::vector<Sign>& signs,
                          Typeset& typeset) const {
  const std::vector<LineEnd> ends = LineEndsOf(line);
  std::vector<FoldedChar> run;
  std::vector<LineEnd> run_ends;
  const auto end_run = [&] {
    if (!run.empty()) WriteRun(run, run_ends, signs);
    run.clear();
    run_ends.clear();
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const FoldedChar& c = line[i];
    if (c.changed && c.kind != Kind::kMissing) {
      Note(typeset.folded, typeset.folded_count, text, line_number, c, Became(line, i));
    }
    if (c.kind == Kind::kMissing) {
      Note(typeset.missing, typeset.missing_count, text, line_number, c, {});
    } else if (c.kind == Kind::kSpace || (c.kind == Kind::kSign && table_.Has(c.code))) {
      run.push_back(c);
      run_ends.push_back(ends[i]);
    } else if (c.kind == Kind::kSign) {
      end_run();
      signs.push_back({GlyphOf(script_, c.code), c.begin, c.end});
      signs.back().keep_next = ends[i].keep_next;
      signs.back().bound = ends[i].bound;
      signs.back().mark = ends[i].mark;
      signs.back().break_after = ends[i].may_end;
    }
  }
  end_run();
}

}  // namespace moontrace
