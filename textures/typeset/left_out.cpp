#include "textures/typeset/left_out.h"

#include <algorithm>

#include "textures/typeset/line_ends.h"

namespace moontrace {
namespace {

/// A range of a line's characters.
struct Range {
  std::size_t begin = 0, end = 0;
};

bool IsDigit(const FoldedChar& c) { return c.code >= U'0' && c.code <= U'9'; }

/// From the first letter or digit of a word to behind its last; empty: it has none.
Range CoreOf(const std::vector<FoldedChar>& line, Range word) {
  Range core{word.end, word.end};
  for (std::size_t i = word.begin; i < word.end; ++i) {
    if (!line[i].letter && !IsDigit(line[i])) continue;
    core.begin = std::min(core.begin, i);
    core.end = i + 1;
  }
  return core.begin == word.end ? Range{} : core;
}

}  // namespace

bool LeavesOutWords(const std::vector<std::string>& only) {
  return std::find(only.begin(), only.end(), kLeftOutMark) != only.end();
}

void LeaveOutWords(const std::vector<FoldedChar>& line, const WrittenLine& written,
                   std::uint32_t mark, std::size_t begin, std::vector<Sign>& signs) {
  if (std::find(written.untaught.begin(), written.untaught.end(), true) == written.untaught.end()) {
    return;
  }
  const std::vector<LineEnd> ends = LineEndsOf(line);
  const std::vector<Sign> all(signs.begin() + static_cast<std::ptrdiff_t>(begin), signs.end());
  signs.resize(begin);
  const auto keep = [&](std::size_t from, std::size_t to) {
    const auto sign = [&](std::size_t c) {
      return c < line.size() ? written.first[c] - begin : all.size();
    };
    signs.insert(signs.end(), all.begin() + static_cast<std::ptrdiff_t>(sign(from)),
                 all.begin() + static_cast<std::ptrdiff_t>(sign(to)));
  };
  for (std::size_t at = 0; at < line.size();) {
    Range word{at, at};
    while (word.end < line.size() && line[word.end].kind != FoldedChar::Kind::kSpace) ++word.end;
    const Range core = CoreOf(line, word);
    const auto lacking = written.untaught.begin() + static_cast<std::ptrdiff_t>(core.begin);
    const auto behind = written.untaught.begin() + static_cast<std::ptrdiff_t>(core.end);
    at = std::min(std::max(word.end, at + 1), line.size());
    if (std::find(lacking, behind, true) == behind) {
      keep(word.begin, at);
      continue;
    }
    keep(word.begin, core.begin);
    const LineEnd& end = ends[core.end - 1];
    signs.push_back({mark, line[core.begin].begin, line[core.end - 1].end});
    signs.back().keep_next = end.keep_next;
    signs.back().bound = end.bound;
    keep(core.end, word.end);
    at = word.end;
  }
}

void CountLeftOut(const TextPage& page, const Script& script, LeftOutWords& counts) {
  const std::size_t mark = script.Find(kLeftOutMark);
  const PlacedGlyph* before = nullptr;
  for (const PlacedGlyph& glyph : page.glyphs) {
    if (glyph.kind == LineKind::kHead || glyph.bridge) continue;
    if (before == nullptr || before->word != glyph.word) ++counts.words;
    if (glyph.glyph == mark) ++counts.left_out;
    before = &glyph;
  }
}

}  // namespace moontrace
