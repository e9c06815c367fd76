#include "lessons/documents/text_document.h"

#include <algorithm>
#include <array>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "lessons/documents/block_writer.h"
#include "textures/base/text_file.h"
#include "textures/base/utf8.h"

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

/// The width of one paragraph, which may have been broken to less than others.
std::size_t WidthIn(const Lines& lines, std::size_t first, std::size_t end, std::size_t width) {
  std::size_t longest = 0;
  for (std::size_t i = first; i < end; ++i) longest = std::max(longest, CountCharacters(lines[i]));
  return longest * 5 < width * 4 ? width : std::min(longest, width);
}

/// Whether the ends of the lines say nothing. In prose a line may end early, before a long word or
/// a dash that was set without blanks, but hardly ever; in verse most do.
bool IsRunning(const Lines& lines, std::size_t first, std::size_t end, std::size_t width) {
  if (end - first < 2 || width < kNarrow) return false;
  width = WidthIn(lines, first, end, width);
  std::size_t early = 0;
  for (std::size_t i = first; i + 1 < end; ++i) {
    if (BeginsItem(lines[i + 1]) || IsIndented(lines[i + 1])) return false;
    const std::size_t length = CountCharacters(lines[i]);
    if (length + 1 + FirstWord(lines[i + 1]) > width) continue;
    if (length * 4 < width * 3) return false;
    ++early;
  }
  return early * 4 < end - first;
}

/// Where paragraphs end that only their first lines, set in, part, as in older books; nothing where
/// the lines are no such paragraphs.
std::vector<std::size_t> IndentedEnds(const Lines& lines, std::size_t first, std::size_t end,
                                      std::size_t width) {
  std::vector<std::size_t> ends;
  std::size_t begin = first;
  bool running = false;
  for (std::size_t i = first + 1; i <= end; ++i) {
    const bool ends_here = i == end || lines[i][0] == ' ' || lines[i][0] == '\t';
    if (!ends_here) continue;
    const bool one_line = i == begin + 1 && CountCharacters(lines[begin]) <= width;
    if (!one_line && !IsRunning(lines, begin, i, width)) return {};
    running = running || !one_line;
    ends.push_back(i);
    begin = i;
  }
  return running ? ends : std::vector<std::size_t>();
}

bool IsAsciiLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
/// Of a word: letters, and all characters above ASCII.
bool IsOfWord(char c) { return IsAsciiLetter(c) || (static_cast<unsigned char>(c) & 0x80U) != 0; }

/// Hyphens at the ends of lines: whether they part a word only there. The text itself tells, where
/// it has the word elsewhere; otherwise whether many of its lines end so.
class LineHyphens {
 public:
  explicit LineHyphens(const Lines& lines) {
    std::size_t broken = 0, hyphens = 0;
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
      if (IsBlank(lines[i]) || IsBlank(lines[i + 1])) continue;
      ++broken;
      const std::string word = WordAt(lines[i], lines[i + 1]);
      if (word.empty()) continue;
      ++hyphens;
      seen_[word] = false;
    }
    constexpr std::size_t kHyphenated = 25;  // one line in so many; compounds end fewer
    hyphenated_ = hyphens * kHyphenated > broken;
    if (!seen_.empty()) {
      for (const std::string_view line : lines) LookFor(line);
    }
  }

  /// A hyphen with a word's parts on both sides.
  static bool Between(std::string_view line, std::string_view next) {
    const std::size_t begin = next.find_first_not_of(' ');
    return line.size() >= 2 && line.back() == '-' && IsOfWord(line[line.size() - 2]) &&
           begin != std::string_view::npos && IsOfWord(next[begin]) &&
           !(next[begin] >= 'A' && next[begin] <= 'Z');
  }

  /// Whether a hyphen between them is none within a line.
  bool Parts(std::string_view line, std::string_view next) const {
    const auto found = seen_.find(WordAt(line, next));
    return found != seen_.end() && (found->second || hyphenated_);
  }

 private:
  /// The word of both lines' parts; empty: none is parted.
  static std::string WordAt(std::string_view line, std::string_view next) {
    if (!Between(line, next)) return {};
    line.remove_suffix(1);
    std::size_t begin = line.size();
    while (begin > 0 && IsOfWord(line[begin - 1])) --begin;
    next.remove_prefix(next.find_first_not_of(' '));
    std::size_t end = 0;
    while (end < next.size() && IsOfWord(next[end])) ++end;
    return LowerCase(line.substr(begin)) + LowerCase(next.substr(0, end));
  }

  void LookFor(std::string_view line) {
    for (std::size_t at = 0; at < line.size(); ++at) {
      const std::size_t begin = at;
      while (at < line.size() && IsOfWord(line[at])) ++at;
      if (at == begin) continue;
      const auto found = seen_.find(LowerCase(line.substr(begin, at - begin)));
      if (found != seen_.end()) found->second = true;
    }
  }

  std::unordered_map<std::string, bool> seen_;  // of each parted word: it stands whole elsewhere
  bool hyphenated_ = false;
};

/// A word by which chapters are counted, before their number.
bool CountsChapters(std::string_view line) {
  static constexpr std::array<std::string_view, 26> kWords = {
      "chapter",  "book",     "part",     "act",       "scene",    "canto",    "volume",
      "section",  "kapitel",  "chapitre", "livre",     "partie",   "buch",     "teil",
      "capitolo", "capítulo", "parte",    "hoofdstuk", "rozdział", "kapitola", "fejezet",
      "luku",     "bölüm",    "глава",    "часть",     "κεφάλαιο"};
  const std::size_t end = line.find(' ');
  if (end == std::string_view::npos) return false;
  const std::string word = CaseFolded(line.substr(0, end));
  if (std::find(kWords.begin(), kWords.end(), word) == kWords.end()) return false;
  const std::string_view rest = line.substr(end + 1);
  const std::string_view number = rest.substr(0, rest.find_first_of(" .:,-"));
  if (number.empty()) return false;
  if (number.find_first_not_of("0123456789") == std::string_view::npos) return true;
  // small letters before a space are a word: "parte di"
  const bool is_word = number[0] >= 'a' && rest.substr(number.size(), 1) == " ";
  return !is_word && LowerCase(number).find_first_not_of("ivxlcdm") == std::string::npos;
}

bool IsCapitals(std::string_view line) {
  if (line[0] == '*' || line[0] == '[' || line.back() == ',') return false;
  int capitals = 0;
  for (const char32_t c : ToCodePoints(line)) {
    if (!IsLetter(c) || IsMark(c) || c == U'ª' || c == U'º') continue;
    const std::string letter = ToUtf8(c);
    if (CaseFolded(letter) == letter) return false;
    ++capitals;
  }
  return capitals > 2;
}

/// Whether lines that stand apart by more than one blank line are the heading of a chapter, as
/// Project Gutenberg's texts have them: counted, or in capitals.
bool IsHeading(const Lines& lines, std::size_t first, std::size_t end) {
  constexpr std::size_t kMostLines = 3, kLongest = 60;  // lines, characters; ours
  if (end - first > kMostLines) return false;
  for (std::size_t i = first; i < end; ++i) {
    if (CountCharacters(lines[i]) > kLongest) return false;
  }
  std::string_view line = lines[first];
  line.remove_prefix(line.find_first_not_of(" \t"));
  line = line.substr(0, line.find_last_not_of(" \t\r\v") + 1);
  return CountsChapters(line) || (end - first == 1 && IsCapitals(line));
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

/// A paragraph whose line ends say nothing.
void WriteRunning(const Lines& lines, std::size_t first, std::size_t end,
                  const LineHyphens& hyphens, BlockWriter& writer) {
  for (std::size_t i = first; i < end; ++i) {
    const bool next = i + 1 < end;
    const bool hyphen = next && LineHyphens::Between(lines[i], lines[i + 1]);
    const bool parts = hyphen && hyphens.Parts(lines[i], lines[i + 1]);
    std::string_view line = lines[i];
    if (parts) line.remove_suffix(1);
    if (i > first && LineHyphens::Between(lines[i - 1], line)) {
      line.remove_prefix(line.find_first_not_of(' '));
    }
    writer.Append(line, {});
    if (next && !hyphen) writer.Append(" ", {});
  }
  writer.End();
}

void WriteLines(const Lines& lines, std::size_t first, std::size_t end, std::size_t width,
                const LineHyphens& hyphens, BlockWriter& writer) {
  if (end - first == 1 || IsRunning(lines, first, end, width)) {
    WriteRunning(lines, first, end, hyphens, writer);
    return;
  }
  const std::vector<std::size_t> ends = IndentedEnds(lines, first, end, width);
  for (std::size_t begin = first; const std::size_t one : ends) {
    WriteRunning(lines, begin, one, hyphens, writer);
    begin = one;
  }
  if (!ends.empty()) return;
  WritingState state;
  state.kind = BlockKind::kVerse;
  state.verbatim = true;
  for (std::size_t i = first; i < end; ++i) {
    if (i > first) writer.Append("\n", state);
    writer.Append(lines[i], state);
  }
  writer.End();
}

void WriteHeading(const Lines& lines, std::size_t first, std::size_t end, BlockWriter& writer) {
  WritingState state;
  state.kind = BlockKind::kHeading;
  state.level = 1;
  for (std::size_t i = first; i < end; ++i) {
    writer.Append(lines[i], state);
    writer.Append(" ", state);
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
  const LineHyphens hyphens(lines);
  std::size_t blank = 0;  // lines before this one
  for (std::size_t i = 0; i < lines.size();) {
    if (IsBlank(lines[i])) {
      ++blank;
      ++i;
      continue;
    }
    const bool apart = std::exchange(blank, 0) > 1;
    std::size_t end = i;
    char mark = ' ';
    while (end < lines.size() && !IsBlank(lines[end]) &&
           (!marks || MarkAt(lines[end], mark) == 0)) {
      ++end;
    }
    if (apart && !marks && IsHeading(lines, i, end)) {
      WriteHeading(lines, i, end, writer);
    } else if (end > i) {
      WriteLines(lines, i, end, width, hyphens, writer);
    }
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
