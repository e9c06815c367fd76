#include "lessons/documents/block_writer.h"

#include <algorithm>
#include <utility>

#include "textures/base/error.h"

namespace moontrace {
namespace {

bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

/// Bytes of a wide or a hard space at the beginning: of one that print sets beside others to move
/// words about, a column of Word's lists or an empty line; 0: it begins otherwise.
std::size_t WideBlank(std::string_view text) {
  for (const std::string_view blank :
       {"\xC2\xA0", "\xE2\x80\x82", "\xE2\x80\x83", "\xE3\x80\x80"}) {
    if (text.substr(0, blank.size()) == blank) return blank.size();
  }
  return 0;
}

}  // namespace

std::uint32_t BlockWriter::Value(std::string_view value) {
  values_.emplace_back(value);
  return static_cast<std::uint32_t>(values_.size() - 1);
}

void BlockWriter::SetLabel(std::string label) {
  if (text_.text.empty()) text_.label.clear();
  label_ = std::move(label);
}

std::string BlockWriter::TakeLabel() {
  if (!label_.empty()) return std::exchange(label_, {});
  return text_.text.empty() ? std::exchange(text_.label, {}) : std::string();
}

void BlockWriter::Begin(const WritingState& state) {
  text_.kind = state.kind;
  text_.level = state.level;
  text_.quotation = state.quotation;
  text_.note = state.note;
  if (!label_.empty()) text_.label = std::exchange(label_, {});
  verbatim_ = state.verbatim;
  blank_.clear();
}

// A mark goes on over the space before a word where both are of the same element.
void BlockWriter::Extend(const WritingState& state, std::size_t before, std::size_t begin) {
  for (std::size_t kind = 0; kind < state.marks.size(); ++kind) {
    const std::uint32_t value = state.marks[kind];
    if (value == 0) continue;
    OpenMark& open = open_[kind];
    if (open.value == value && open.index < text_.marks.size() &&
        text_.marks[open.index].end == before) {
      text_.marks[open.index].end = text_.text.size();
      continue;
    }
    open = {text_.marks.size(), value};
    text_.marks.push_back({static_cast<MarkKind>(kind), begin, text_.text.size(), values_[value]});
  }
}

void BlockWriter::Put(std::string_view word, const WritingState& state) {
  if (text_.text.empty()) Begin(state);
  const std::size_t before = text_.text.size();
  text_.text += std::exchange(blank_, {});
  const std::size_t begin = text_.text.size();
  text_.text.append(word);
  written_ += word.size();
  Extend(state, before, begin);
}

void BlockWriter::PutVerbatim(std::string_view text, const WritingState& state) {
  if (text_.text.empty()) Begin(state);
  const std::size_t begin = text_.text.size();
  text_.text.append(text);
  written_ += text.size();
  Extend(state, begin, begin);
}

void BlockWriter::Append(std::string_view text, const WritingState& state) {
  if (state.verbatim) {
    if (!text.empty()) PutVerbatim(text, state);
    return;
  }
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && !IsBlank(text[end]) && WideBlank(text.substr(end, 3)) == 0) ++end;
    if (end > at) Put(text.substr(at, end - at), state);
    at = end;
    while (at < text.size()) {
      const std::size_t length = IsBlank(text[at]) ? std::size_t{1} : WideBlank(text.substr(at, 3));
      if (length == 0) break;
      PutBlank(text.substr(at, length));
      at += length;
    }
  }
}

// One wide space alone stays what it is; several are a space.
void BlockWriter::PutBlank(std::string_view blank) {
  if (text_.text.empty() || text_.text.back() == '\n') return;
  const bool wide = blank_.empty() && blank.size() > 1;
  blank_ = wide ? blank : " ";
}

void BlockWriter::Break() {
  if (text_.text.empty()) return;
  blank_.clear();
  if (text_.text.back() == '\n' && !verbatim_) {
    End();
  } else {
    text_.text += '\n';
  }
}

void BlockWriter::BeginLine() {
  if (!text_.text.empty() && text_.text.back() != '\n') Break();
}

void BlockWriter::Point(MarkKind kind, std::string_view value, const WritingState& state) {
  if (text_.text.empty() && kind == MarkKind::kPicture) Begin(state);
  if (!text_.text.empty()) text_.text += std::exchange(blank_, {});
  text_.marks.push_back({kind, text_.text.size(), text_.text.size(), std::string(value)});
}

// Blanks at the edges, and marks held to what is left.
void BlockWriter::Trim() {
  std::string& text = text_.text;
  std::size_t end = text.size();
  while (end > 0 && IsBlank(text[end - 1])) --end;
  text.resize(end);
  std::size_t begin = 0;
  if (verbatim_) {  // whole lines only: the others are set in
    const std::size_t first = std::min(text.find_first_not_of(" \t\r\n\f"), text.size());
    const std::size_t line = first == 0 ? std::string::npos : text.rfind('\n', first - 1);
    begin = line == std::string::npos ? 0 : line + 1;
  }
  text.erase(0, begin);
  for (DocumentMark& mark : text_.marks) {
    mark.begin = std::min(mark.begin - std::min(mark.begin, begin), text.size());
    mark.end = std::min(mark.end - std::min(mark.end, begin), text.size());
  }
  std::stable_sort(text_.marks.begin(), text_.marks.end(),
                   [](const DocumentMark& a, const DocumentMark& b) { return a.begin < b.begin; });
}

void BlockWriter::End() {
  Trim();
  const bool pictured =
      std::any_of(text_.marks.begin(), text_.marks.end(),
                  [](const DocumentMark& mark) { return mark.kind == MarkKind::kPicture; });
  if (text_.text.empty() && !pictured) {
    // Where a print page begins is told to the block that follows.
    std::erase_if(text_.marks,
                  [](const DocumentMark& m) { return m.kind != MarkKind::kPrintPage; });
    return;
  }
  Add(std::exchange(text_, {}));
  open_ = {};
}

std::size_t BlockWriter::Add(Block block) {
  if (document_.blocks.size() >= kMostBlocks) {
    throw InputError(name_ + ": holds more than " + std::to_string(kMostBlocks) +
                     " paragraphs; split it");
  }
  document_.blocks.push_back(std::move(block));
  return document_.blocks.size() - 1;
}

}  // namespace moontrace
