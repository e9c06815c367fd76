#include "lessons/documents/text_document.h"

#include <algorithm>
#include <vector>

#include "lessons/documents/block_writer.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

constexpr std::size_t kNarrow = 45;  // characters; shorter lines are not broken for want of room
constexpr std::size_t kIndented = 4;

using Lines = std::vector<std::string_view>;

bool IsBlank(std::string_view line) {
  return line.find_first_not_of(" \t\r\v") == std::string_view::npos;
}

/// The lines of a text, without their ends; a form feed is a blank line of its own.
Lines LinesOf(std::string_view text) {
  Lines lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\n\r\f", at), text.size());
    lines.push_back(text.substr(at, end - at));
    if (end < text.size() && text[end] == '\f') lines.emplace_back();
    at = end + 1;
    if (end < text.size() && text[end] == '\r' && at < text.size() && text[at] == '\n') ++at;
  }
  return lines;
}

/// Characters to which the text was broken: nine in ten lines that another follows are no longer.
std::size_t WidthOf(const Lines& lines) {
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    if (!IsBlank(lines[i]) && !IsBlank(lines[i + 1])) widths.push_back(CountCharacters(lines[i]));
  }
  if (widths.empty()) return 0;
  const auto most = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() * 9 / 10);
  std::nth_element(widths.begin(), most, widths.end());
  return *most;
}

std::size_t FirstWord(std::string_view line) {
  const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
  const std::size_t end = std::min(line.find_first_of(" \t", begin), line.size());
  return CountCharacters(line.substr(begin, end - begin));
}

bool IsIndented(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(' ');
  return begin != std::string_view::npos && (begin >= kIndented || line[begin] == '\t');
}

/// "- x", "* x", "12. x", "a) x"
bool BeginsItem(std::string_view line) {
  const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
  line.remove_prefix(begin);
  const std::size_t blank = line.find(' ');
  if (blank == std::string_view::npos || blank == 0 || blank > 4) return false;
  const std::string_view mark = line.substr(0, blank);
  if (mark == "-" || mark == "*" || mark == "+" || mark == "\xE2\x80\xA2") return true;
  return blank >= 2 && (mark.back() == '.' || mark.back() == ')') &&
         (std::all_of(mark.begin(), mark.end() - 1, [](char c) { return c >= '0' && c <= '9'; }) ||
          (blank == 2 && mark.back() == ')'));
}

/// Whether the ends of the lines say nothing.
bool IsRunning(const Lines& lines, std::size_t first, std::size_t end, std::size_t width) {
  if (end - first < 2 || width < kNarrow) return false;
  for (std::size_t i = first; i + 1 < end; ++i) {
    if (BeginsItem(lines[i]) || BeginsItem(lines[i + 1]) || IsIndented(lines[i + 1])) return false;
    if (CountCharacters(lines[i]) + 1 + FirstWord(lines[i + 1]) <= width) return false;
  }
  return true;
}

/// Characters of "# " to "### " or "> " at the beginning; 0 for others.
std::size_t MarkAt(std::string_view line, char& mark) {
  std::size_t at = 0;
  mark = line.empty() ? ' ' : line[0];
  if (mark != '#' && mark != '>') return 0;
  while (at < line.size() && line[at] == mark) ++at;
  const bool sound =
      mark == '#' ? at <= 3 && at < line.size() && line[at] == ' ' && !IsBlank(line.substr(at))
                  : at == 1 && (at == line.size() || line[at] == ' ');
  return sound ? at : 0;
}

void WriteLines(const Lines& lines, std::size_t first, std::size_t end, std::size_t width,
                BlockWriter& writer) {
  const bool running = IsRunning(lines, first, end, width);
  WritingState state;
  if (!running && end - first > 1) {
    state.kind = BlockKind::kVerse;
    state.verbatim = true;
  }
  for (std::size_t i = first; i < end; ++i) {
    if (i > first) running ? writer.Append(" ", state) : writer.Append("\n", state);
    writer.Append(lines[i], state);
  }
  writer.End();
}

void WriteMarked(std::string_view line, std::size_t length, char mark, BlockWriter& writer) {
  WritingState state;
  if (mark == '#') {
    state.kind = BlockKind::kHeading;
    state.level = static_cast<std::int16_t>(length);
  } else {
    state.quotation = 1;
  }
  writer.Append(line.substr(length), state);
  writer.End();
}

}  // namespace

Document ReadPlainText(std::string_view text, const std::string& name, bool marks) {
  Document document;
  document.parts.push_back({});
  BlockWriter writer(document, name);
  const Lines lines = LinesOf(text);
  const std::size_t width = WidthOf(lines);
  for (std::size_t i = 0; i < lines.size();) {
    if (IsBlank(lines[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    char mark = ' ';
    while (end < lines.size() && !IsBlank(lines[end]) &&
           (!marks || MarkAt(lines[end], mark) == 0)) {
      ++end;
    }
    if (end > i) WriteLines(lines, i, end, width, writer);
    i = end;
    if (i < lines.size() && !IsBlank(lines[i])) {
      const std::size_t length = MarkAt(lines[i], mark);
      WriteMarked(lines[i], length, mark, writer);
      ++i;
    }
  }
  return document;
}

}  // namespace moontrace
