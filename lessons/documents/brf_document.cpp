#include "lessons/documents/brf_document.h"

#include <algorithm>
#include <array>
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

struct BrfLine {
  std::size_t indent = 0;  // blank cells before it
  std::size_t cells = 0;   // of the rest
  std::string text;        // patterns; empty: a blank line
};

/// The line of the bytes; those that are no cell are counted in `bad`.
BrfLine LineOf(std::string_view bytes, std::size_t& bad) {
  static const std::array<int, 256> kDots = DotsOfBytes();
  BrfLine line;
  while (!bytes.empty() && (bytes.back() == ' ' || bytes.back() == '\t')) bytes.remove_suffix(1);
  while (line.indent < bytes.size() && bytes[line.indent] == ' ') ++line.indent;
  for (const char c : bytes.substr(line.indent)) {
    const int dots = kDots[static_cast<unsigned char>(c)];
    if (dots == 0) {
      line.text += ' ';
    } else if (dots > 0) {
      line.text += ToUtf8(static_cast<char32_t>(0x2800 + dots));
    } else {
      line.text += "\xEF\xBF\xBD";
      ++bad;
    }
    ++line.cells;
  }
  return line;
}

std::vector<BrfLine> LinesOf(std::string_view bytes, std::size_t& bad) {
  std::vector<BrfLine> lines;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find_first_of("\n\r\f\x1a", at), bytes.size());
    lines.push_back(LineOf(bytes.substr(at, end - at), bad));
    at = end + 1;
    if (end < bytes.size() && bytes[end] == '\r' && at < bytes.size() && bytes[at] == '\n') ++at;
  }
  return lines;
}

bool IsHeading(const BrfLine& line, std::size_t width) {
  const std::size_t used = line.indent + line.cells;
  if (line.indent < kHeadingIndent || line.cells == 0 || used > width) return false;
  const std::size_t right = width - used;
  return std::max(right, line.indent) - std::min(right, line.indent) <= kOffMiddle;
}

bool IsPattern(char32_t c) { return c >= 0x2800 && c <= 0x28FF; }

}  // namespace

Document ReadBrf(std::string_view bytes, const std::string& name) {
  Document document;
  document.format = DocumentFormat::kBrf;
  document.encoding = "ASCII Braille";
  document.parts.push_back({});
  std::size_t bad = 0;
  const std::vector<BrfLine> lines = LinesOf(bytes, bad);
  std::size_t width = kUsualWidth;
  for (const BrfLine& line : lines) width = std::max(width, line.indent + line.cells);
  BlockWriter writer(document, name);
  bool heading_before = false;
  for (const BrfLine& line : lines) {
    WritingState state;
    const bool heading = IsHeading(line, width);
    if (line.text.empty() || heading != heading_before || (line.indent > 0 && !heading)) {
      writer.End();
    }
    heading_before = heading;
    if (line.text.empty()) continue;
    if (heading) {
      state.kind = BlockKind::kHeading;
      state.level = 1;
    }
    writer.Append(line.text + " ", state);
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
