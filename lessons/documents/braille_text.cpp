#include "lessons/documents/braille_text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "textures/base/utf8.h"
#include "textures/typeset/louis.h"

namespace moontrace {
namespace {

constexpr std::size_t kMostCells = 2000;  // are read at once, up to a blank

/// A run of a block's text: patterns and the blanks between them, or other text.
struct Run {
  std::size_t begin = 0, end = 0;   // bytes
  std::vector<std::uint8_t> cells;  // empty: other text
};

/// The runs between `begin` and `end`.
void AddRuns(std::string_view text, std::size_t begin, std::size_t end, std::vector<Run>& runs) {
  bool open = false;
  for (std::size_t i = begin; i < end;) {
    char32_t c = 0;
    const std::size_t length = std::max<std::size_t>(1, Decode(text.substr(i, end - i), c));
    const bool pattern = c >= 0x2800 && c <= 0x28FF;
    const bool blank = c == ' ' || c == 0x2800;
    const bool goes_on = open && (pattern || blank) && !runs.back().cells.empty();
    const bool full = goes_on && blank && runs.back().cells.size() >= kMostCells;
    if (!goes_on && (!open || pattern || !runs.back().cells.empty())) {
      runs.push_back({i, i, {}});
      open = true;
    }
    if (goes_on || pattern) {
      runs.back().cells.push_back(blank ? 0 : static_cast<std::uint8_t>(c - 0x2800));
    }
    i += length;
    runs.back().end = i;
    open = !full;
  }
}

std::size_t Words(std::string_view text) {
  std::size_t words = 0;
  bool in_word = false;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n';
    if (!blank && !in_word) ++words;
    in_word = !blank;
  }
  return words;
}

/// The cells as a table reads them. Where that has other words than the cells, they are read word
/// by word, and one that is not read stays.
std::string ReadRun(const BrailleTable& table, const Run& run, std::string_view as_written) {
  std::string read = table.ReadBack(run.cells);
  std::string cells(as_written);
  if (Words(read) == Words(cells)) {
    if (run.cells.back() == 0 && (read.empty() || read.back() != ' ')) read += ' ';
    return read;
  }
  read.clear();
  std::size_t at = 0;
  std::vector<std::uint8_t> word;
  std::string written;
  const auto put = [&] {
    if (word.empty()) return;
    const std::string as_read = table.ReadBack(word);
    read += as_read.find_first_not_of(' ') == std::string::npos ? written : as_read;
    word.clear();
    written.clear();
  };
  for (const std::uint8_t dots : run.cells) {
    char32_t c = 0;
    const std::size_t length = std::max<std::size_t>(1, Decode(as_written.substr(at), c));
    if (dots == 0) {
      put();
      read += ' ';
    } else {
      word.push_back(dots);
      written += as_written.substr(at, length);
    }
    at += length;
  }
  put();
  return read;
}

/// Places where a run ends in any case.
std::vector<std::size_t> CutsOf(const Block& block) {
  std::vector<std::size_t> cuts{0, block.text.size()};
  for (const DocumentMark& mark : block.marks) {
    cuts.push_back(mark.begin);
    cuts.push_back(mark.end);
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

std::string Read(const BrailleTable& table, const std::string& text) {
  std::vector<Run> runs;
  AddRuns(text, 0, text.size(), runs);
  std::string read;
  for (const Run& run : runs) {
    const std::string_view piece = std::string_view(text).substr(run.begin, run.end - run.begin);
    read += run.cells.empty() ? std::string(piece) : ReadRun(table, run, piece);
  }
  return read;
}

void ReadBlock(const BrailleTable& table, Block& block) {
  const std::vector<std::size_t> cuts = CutsOf(block);
  std::vector<std::size_t> moved(cuts.size());
  std::string text;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    text += Read(table, block.text.substr(cuts[i], cuts[i + 1] - cuts[i]));
    moved[i + 1] = text.size();
  }
  const auto at = [&](std::size_t byte) {
    const auto cut = std::lower_bound(cuts.begin(), cuts.end(), byte);
    return moved[static_cast<std::size_t>(cut - cuts.begin())];
  };
  for (DocumentMark& mark : block.marks) {
    mark.begin = at(mark.begin);
    mark.end = at(mark.end);
  }
  block.text = std::move(text);
  block.label = Read(table, block.label);
  block.column_name = Read(table, block.column_name);
}

}  // namespace

std::string BrailleTableFor(const std::string& language) {
  constexpr std::array<std::pair<std::string_view, const char*>, 6> kTables = {{
      {"de", "de-g2.ctb"},
      {"fr", "fr-bfu-g2.ctb"},
      {"es", "es-g1.ctb"},
      {"it", "it-it-comp6.utb"},
      {"nl", "nl-NL-g0.utb"},
      {"pt", "pt-pt-g2.ctb"},
  }};
  const std::string_view tag = std::string_view(language).substr(0, language.find('-'));
  for (const auto& [of, table] : kTables) {
    if (of == tag) return table;
  }
  return "en-ueb-g2.ctb";
}

void ReadPatterns(Document& document, const std::string& table) {
  const BrailleTable reader(table);
  for (Block& block : document.blocks) ReadBlock(reader, block);
  for (ContentsEntry& entry : document.contents) entry.title = Read(reader, entry.title);
  document.title = Read(reader, document.title);
}

}  // namespace moontrace
