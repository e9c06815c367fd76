#include "lessons/documents/transcribe.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "textures/base/utf8.h"

namespace moontrace {
namespace {

constexpr std::size_t kLongestAddress = 200;

std::string Counted(std::uint32_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// An address in one word, its parentheses escaped, so that the mark ends behind it.
std::string Address(std::string_view value) {
  std::string address;
  for (const char c : value) {
    if (c == '(' || c == ')') {
      address += c == '(' ? "%28" : "%29";
    } else if (static_cast<unsigned char>(c) > ' ') {
      address += c;
    }
    if (address.size() >= kLongestAddress) return "#";
  }
  return address.empty() ? "#" : address;
}

/// What is put into a block's text at a place.
struct Insertion {
  std::size_t at = 0;
  int order = 0;  // at the same place
  std::string words;
  bool mark = false;   // of a link: no text
  std::size_t of = 0;  // mark of the block
};

enum : int {
  kEndPicture = 0,
  kEndLink = 1,
  kPage = 2,
  kAlone = 3,
  kBeginLink = 4,
  kBeginPicture = 5
};

/// A link's words on each of its lines.
void InsertLink(const DocumentMark& mark, std::size_t of, const std::string& text,
                std::vector<Insertion>& insertions) {
  for (std::size_t begin = mark.begin; begin < mark.end;) {
    std::size_t end = std::min(text.find('\n', begin), mark.end);
    const std::size_t next = end + 1;
    while (begin < end && text[begin] == '[' && text[end - 1] == ']') {
      ++begin;
      --end;
    }
    const std::string_view words = std::string_view(text).substr(begin, end - begin);
    if (words.find_first_of("[]") == std::string_view::npos &&
        words.find_first_not_of(" \t") != std::string_view::npos) {
      insertions.push_back({begin, kBeginLink, "[", true, of});
      insertions.push_back({end, kEndLink, "](" + Address(mark.value) + ")", true, of});
    }
    begin = next;
  }
}

/// Whether a picture is the first letter of a word, large and adorned: it is read as that letter.
bool IsInitial(const DocumentMark& mark, std::string_view text) {
  char32_t letter = 0, next = 0;
  const std::size_t length = Decode(text.substr(mark.begin, mark.end - mark.begin), letter);
  if (length == 0 || length != mark.end - mark.begin || !IsLetter(letter)) return false;
  return Decode(text.substr(mark.end), next) > 0 && IsLetter(next);
}

std::vector<Insertion> InsertionsOf(const Block& block) {
  std::vector<Insertion> insertions;
  for (std::size_t i = 0; i < block.marks.size(); ++i) {
    const DocumentMark& mark = block.marks[i];
    if (mark.kind == MarkKind::kLink || mark.kind == MarkKind::kNoteCall) {
      InsertLink(mark, i, block.text, insertions);
    } else if (mark.kind == MarkKind::kPrintPage) {
      insertions.push_back({mark.begin, kPage, mark.value, true, i});
    } else if (mark.kind == MarkKind::kPicture && mark.begin == mark.end) {
      insertions.push_back({mark.begin, kAlone, "(picture without description)", false});
    } else if (mark.kind == MarkKind::kPicture && !IsInitial(mark, block.text)) {
      insertions.push_back({mark.begin, kBeginPicture, "(picture: ", false});
      insertions.push_back({mark.end, kEndPicture, ")", false});
    }
  }
  std::stable_sort(insertions.begin(), insertions.end(),
                   [](const Insertion& a, const Insertion& b) {
                     return a.at != b.at ? a.at < b.at : a.order < b.order;
                   });
  return insertions;
}

/// Whether "[" of its text could be taken for a mark's, or a backslash before it for one of ours.
bool HasBrackets(const Block& block) {
  for (const std::string* text : {&block.text, &block.label, &block.column_name}) {
    if (text->find("](") != std::string::npos || text->find("\\[") != std::string::npos)
      return true;
  }
  return block.text.find(']') != std::string::npos &&
         std::any_of(block.marks.begin(), block.marks.end(),
                     [](const DocumentMark& mark) { return mark.kind == MarkKind::kPicture; });
}

class Transcriber {
 public:
  explicit Transcriber(const Document& document) : document_(document) {}

  Transcription Run() {
    for (std::size_t i = 0; i < document_.blocks.size(); ++i) {
      const Block& block = document_.blocks[i];
      if (i > 0) out_.text += Follows(document_.blocks[i - 1], block) ? "\n" : "\n\n";
      out_.begins.push_back(out_.text.size());
      Write(block);
    }
    out_.text += '\n';
    return std::move(out_);
  }

 private:
  /// Whether a block stands on the line behind the other one, without a paragraph's space.
  static bool Follows(const Block& before, const Block& block) {
    const auto listed = [](const Block& b) {
      return b.kind == BlockKind::kList || b.kind == BlockKind::kListItem;
    };
    const bool begins = block.kind == BlockKind::kList && block.level <= 1;
    if (listed(before) && listed(block) && !begins) return true;
    return block.kind == BlockKind::kCell &&
           (before.kind == BlockKind::kCell || before.kind == BlockKind::kTable);
  }

  /// Text of the document: what it has of marks is none. Line ends begin new lines.
  void Literal(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
      if (line_begins_) BeginLine(text.substr(at));
      if (text[at] == '\n') {
        EndLine();
        ++at;
        continue;
      }
      const bool bracket = text[at] == '[';
      if (bracket && brackets_) out_.text += '\\';
      const std::size_t stop =
          std::min(text.find_first_of("\n[", at + (bracket ? 1 : 0)), text.size());
      out_.text.append(text.substr(at, stop - at));
      at = stop;
    }
  }

  void BeginLine(std::string_view text) {
    if (text[0] == '\n') return;
    out_.text += prefix_;
    line_begins_ = false;
    const std::size_t mark = text.find_first_not_of('\\');
    if (prefix_.empty() && mark != std::string_view::npos &&
        (text[mark] == '#' || text[mark] == '>')) {
      out_.text += '\\';
    }
  }

  void EndLine() {
    if (line_begins_ && !prefix_.empty()) out_.text += prefix_[0];
    if (one_line_) {
      out_.text += ' ';
    } else {
      out_.text += '\n';
      line_begins_ = true;
    }
  }

  void Marked(const Block& block) {
    std::size_t at = 0;
    for (const Insertion& insertion : InsertionsOf(block)) {
      Literal(std::string_view(block.text).substr(at, insertion.at - at));
      at = insertion.at;
      if (!insertion.mark) {
        Literal(insertion.words);
        continue;
      }
      if (insertion.order == kPage) {
        out_.pages.push_back({out_.text.size(), insertion.words});
        continue;
      }
      if (line_begins_) out_.text += prefix_;
      line_begins_ = false;
      if (insertion.order == kEndLink) {
        out_.links.back().end = out_.text.size();
        out_.text += insertion.words;
      } else {
        out_.text += insertion.words;
        const std::size_t begin = out_.text.size();
        out_.links.push_back({begin, begin, out_.begins.size() - 1, insertion.of});
      }
    }
    Literal(std::string_view(block.text).substr(at));
  }

  void Write(const Block& block) {
    prefix_ = block.quotation > 0 ? "> " : "";
    one_line_ = block.kind == BlockKind::kHeading || block.kind == BlockKind::kTable;
    line_begins_ = true;
    brackets_ = HasBrackets(block);
    switch (block.kind) {
      case BlockKind::kHeading:
        prefix_ = std::string(static_cast<std::size_t>(std::clamp(block.level, 1, 3)), '#') + " ";
        if (block.label != "-") Label(block);
        break;
      case BlockKind::kList:
        Literal("list of " + Counted(block.row, "item", "items"));
        if (block.level > 1) Literal(", level " + std::to_string(block.level));
        return;
      case BlockKind::kListItem:
      case BlockKind::kVerse:
      case BlockKind::kCode:
        Label(block);
        break;
      case BlockKind::kTable:
        Literal("table of " + Counted(block.row, "row", "rows") + " and " +
                Counted(block.column, "column", "columns"));
        if (!block.text.empty()) Literal(": ");
        Marked(block);
        if (!block.column_name.empty()) Literal("; columns " + block.column_name);
        return;
      case BlockKind::kCell:
        Literal((block.label.empty() ? "row " + std::to_string(block.row) : block.label) + ", " +
                (block.column_name.empty() ? "column " + std::to_string(block.column)
                                           : block.column_name) +
                ": ");
        break;
      case BlockKind::kRule:
        Literal("---");
        return;
      case BlockKind::kParagraph:
        break;
    }
    Marked(block);
  }

  /// An item's number or sign, whatever the item begins with.
  void Label(const Block& block) {
    if (block.label.empty()) return;
    const bool alone = block.text.empty() && block.marks.empty();
    Literal(ItemLabel(block) + (alone ? "" : " "));
  }

  static std::string ItemLabel(const Block& block) {
    if (block.label != "-") return block.label;
    return std::string(static_cast<std::size_t>(std::max(block.level, 1)), '-');
  }

  const Document& document_;
  Transcription out_;
  std::string prefix_;
  bool line_begins_ = true;
  bool one_line_ = false;
  bool brackets_ = false;  // "[" gets a backslash
};

}  // namespace

Transcription Transcribe(const Document& document) { return Transcriber(document).Run(); }

}  // namespace moontrace
