#include "lessons/documents/brf_document.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lessons/documents/block_writer.h"
#include "textures/base/utf8.h"

namespace moontrace {
namespace {

constexpr std::size_t kUsualWidth = 40;    // cells of an embosser's line
constexpr std::size_t kHeadingIndent = 4;  // cells
constexpr std::size_t kOffMiddle = 2;      // a heading lies so near the middle [cells]

/// The characters of the 64 cells by their dots, dot 1 the least bit (North American ASCII Braille,
/// as in liblouis' table en-us-brf.dis).
constexpr std::string_view kCells =
    " A1B'K2L@CIF/MSP\"E3H9O6R^DJG>NTQ,*5<-U8V.%[$+X!&;:4\\0Z7(_?W]#Y)=";

/// The dots of each byte, -1 of one that is no cell.
std::array<int, 256> DotsOfBytes() {
  std::array<int, 256> dots{};
  dots.fill(-1);
  for (std::size_t i = 0; i < kCells.size(); ++i) {
    const char c = kCells[i];
    dots[static_cast<unsigned char>(c)] = static_cast<int>(i);
    // the other column of ASCII: small letters, and `{|}~ of @[\]^
    if (c >= '@' && c <= '^') dots[static_cast<unsigned char>(c) + 32U] = static_cast<int>(i);
  }
  return dots;
}

constexpr char kNoCell = '\x7f';
constexpr std::string_view kTaken = "\x01";  // a line of which nothing is left to read

struct BrfLine {
  std::size_t indent = 0;  // blank cells before it
  std::string cells;       // the rest, by the characters of kCells; empty: a blank line
  std::size_t end() const { return indent + cells.size(); }
};
using BrfLines = std::vector<BrfLine>;

/// The line of the bytes; those that are no cell are counted in `bad`.
BrfLine LineOf(std::string_view bytes, std::size_t& bad) {
  static const std::array<int, 256> kDots = DotsOfBytes();
  BrfLine line;
  while (!bytes.empty() && (bytes.back() == ' ' || bytes.back() == '\t')) bytes.remove_suffix(1);
  while (line.indent < bytes.size() && bytes[line.indent] == ' ') ++line.indent;
  for (const char c : bytes.substr(line.indent)) {
    const int dots = kDots[static_cast<unsigned char>(c)];
    line.cells += dots < 0 ? kNoCell : kCells[static_cast<std::size_t>(dots)];
    bad += dots < 0 ? 1U : 0U;
  }
  return line;
}

std::string PatternsOf(std::string_view cells) {
  std::string text;
  for (const char c : cells) {
    if (c == ' ' || c == kNoCell) {
      text += c == ' ' ? " " : "\xEF\xBF\xBD";
    } else {
      text += ToUtf8(static_cast<char32_t>(0x2800 + kCells.find(c)));
    }
  }
  return text;
}

/// The sheets of an embosser, apart by form feeds, and their lines.
std::vector<BrfLines> SheetsOf(std::string_view bytes, std::size_t& bad) {
  std::vector<BrfLines> sheets(1);
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find_first_of("\n\r\f\x1a", at), bytes.size());
    const bool feed = end < bytes.size() && bytes[end] == '\f';
    if (end > at || !feed) sheets.back().push_back(LineOf(bytes.substr(at, end - at), bad));
    if (feed) sheets.emplace_back();
    at = end + 1;
    if (end < bytes.size() && bytes[end] == '\r' && at < bytes.size() && bytes[at] == '\n') ++at;
  }
  return sheets;
}

bool IsHeading(const BrfLine& line, std::size_t width) {
  if (line.indent < kHeadingIndent || line.cells.empty() || line.end() > width) return false;
  const std::size_t right = width - line.end();
  return std::max(right, line.indent) - std::min(right, line.indent) <= kOffMiddle;
}

/// A number of a page at the end of a line: behind the number sign, letters A to J; of a print page
/// that goes on, a letter before the sign.
struct PageNumber {
  std::size_t begin = 0;  // in the cells
  int value = 0;
  bool goes_on = false;  // of a print page on a further sheet
};
std::optional<PageNumber> NumberAt(std::string_view cells) {
  constexpr std::size_t kMostDigits = 4;
  const std::size_t sign = cells.rfind('#');
  if (sign == std::string_view::npos) return std::nullopt;
  const std::string_view digits = cells.substr(sign + 1);
  if (digits.empty() || digits.size() > kMostDigits) return std::nullopt;
  PageNumber number{sign};
  for (const char c : digits) {
    if (c < 'A' || c > 'J') return std::nullopt;
    number.value = number.value * 10 + (c == 'J' ? 0 : c - 'A' + 1);
  }
  number.goes_on = sign > 0 && cells[sign - 1] >= 'A' && cells[sign - 1] <= 'Z';
  if (number.goes_on) --number.begin;
  return number;
}

/// The number at the right margin of a sheet's first or last line, apart from what else is there.
std::optional<PageNumber> MarginNumber(const BrfLine& line, std::size_t width) {
  constexpr std::size_t kApart = 3;  // blank cells before it (BANA, Braille Formats, 1.11)
  std::optional<PageNumber> number = NumberAt(line.cells);
  if (!number || line.end() + kOffMiddle < width) return std::nullopt;
  const std::size_t text =
      number->begin == 0 ? 0 : line.cells.find_last_not_of(' ', number->begin - 1) + 1;
  if (number->begin > 0 && number->begin - text < kApart) return std::nullopt;
  return number;
}

BrfLine* EdgeOf(BrfLines& sheet, bool first) {
  for (std::size_t i = 0; i < sheet.size(); ++i) {
    BrfLine& line = first ? sheet[i] : sheet[sheet.size() - 1 - i];
    if (!line.cells.empty()) return &line;
  }
  return nullptr;
}

/// Takes the numbers of pages off the first or the last lines, where they count from sheet to
/// sheet, and heads that stand before them on several sheets.
void TakeNumbers(std::vector<BrfLines>& sheets, bool first, std::size_t width) {
  struct Edge {
    BrfLine* line;
    PageNumber number;
  };
  std::vector<Edge> edges;
  std::size_t counted = 0;
  for (BrfLines& sheet : sheets) {
    BrfLine* line = EdgeOf(sheet, first);
    const std::optional<PageNumber> number =
        line == nullptr ? std::nullopt : MarginNumber(*line, width);
    if (!number) continue;
    const int step = edges.empty() ? 1 : number->value - edges.back().number.value;
    counted += step == 1 || step == 2 || (step == 0 && number->goes_on) ? 1U : 0U;
    edges.push_back({line, *number});
  }
  if (edges.size() < 2 || counted * 5 < edges.size() * 4) return;
  std::map<std::string, std::size_t> heads;
  for (const Edge& edge : edges) {
    std::string& cells = edge.line->cells;
    cells.resize(edge.number.begin);
    cells.resize(cells.find_last_not_of(' ') + 1);
    ++heads[cells];
  }
  for (const Edge& edge : edges) {
    if (heads[edge.line->cells] > 1 || edge.line->cells.empty())
      edge.line->cells = std::string(kTaken);
  }
}

/// A line of hyphens that ends in the number of the print page that begins there (BANA, Braille
/// Formats, 1.12); 0: it is none.
int PrintPageAt(const BrfLine& line) {
  constexpr std::size_t kFewest = 10;
  const std::size_t end = std::min(line.cells.find_first_not_of('-'), line.cells.size());
  if (line.indent > 0 || end < kFewest) return 0;
  const std::optional<PageNumber> number = NumberAt(line.cells);
  return number && number->begin == end ? number->value : 0;
}

/// Whether the line ends within a word: at its hyphen, which is no dash.
bool EndsInHyphen(std::string_view cells) {
  return cells.size() > 1 && cells.back() == '-' && cells[cells.size() - 2] >= 'A' &&
         cells[cells.size() - 2] <= 'Z';
}

/// Whether it was a heading.
bool WriteLine(const BrfLine& line, std::size_t width, bool heading_before, BlockWriter& writer) {
  WritingState state;
  if (line.cells == kTaken) return heading_before;
  if (const int page = PrintPageAt(line); page > 0) {
    writer.Point(MarkKind::kPrintPage, std::to_string(page), state);
    return heading_before;
  }
  const bool heading = IsHeading(line, width);
  if (line.cells.empty() || heading != heading_before || (line.indent > 0 && !heading)) {
    writer.End();
  }
  if (line.cells.empty()) return heading;
  if (heading) {
    state.kind = BlockKind::kHeading;
    state.level = 1;
  }
  writer.Append(PatternsOf(line.cells) + (EndsInHyphen(line.cells) ? "" : " "), state);
  return heading;
}

bool IsPattern(char32_t c) { return c >= 0x2800 && c <= 0x28FF; }

}  // namespace

Document ReadBrf(std::string_view bytes, const std::string& name) {
  Document document;
  document.format = DocumentFormat::kBrf;
  document.encoding = "ASCII Braille";
  document.parts.push_back({});
  std::size_t bad = 0;
  std::vector<BrfLines> sheets = SheetsOf(bytes, bad);
  std::size_t width = kUsualWidth, longest = 0;
  for (const BrfLines& sheet : sheets) {
    longest = std::max(longest, sheet.size());
    for (const BrfLine& line : sheet) width = std::max(width, line.end());
  }
  for (const bool first : {true, false}) TakeNumbers(sheets, first, width);
  BlockWriter writer(document, name);
  bool heading_before = false;
  for (const BrfLines& sheet : sheets) {
    for (const BrfLine& line : sheet)
      heading_before = WriteLine(line, width, heading_before, writer);
    if (sheet.size() < longest) writer.End();  // it was left before it was full
  }
  writer.End();
  NoteLeftOut(document, LeftOut::kBadByte, "", bad);
  return document;
}

bool IsBraille(const Document& document) {
  std::size_t patterns = 0, others = 0;
  for (const Block& block : document.blocks) {
    const std::string_view text = block.text;
    for (std::size_t i = 0; i < text.size();) {
      char32_t c = 0;
      i += std::max<std::size_t>(1, Decode(text.substr(i), c));
      if (IsPattern(c)) {
        ++patterns;
      } else if (c > ' ') {
        ++others;
      }
    }
  }
  return patterns > others;
}

}  // namespace moontrace
