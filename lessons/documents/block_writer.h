#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/documents/document.h"

namespace moontrace {

/// How what is written next stands in the document. Cheap to copy: elements hand it down.
struct WritingState {
  BlockKind kind = BlockKind::kParagraph;
  std::int16_t level = 0;
  std::int16_t quotation = 0;
  bool note = false;
  bool verbatim = false;  ///< blanks and line ends count
  /// For each kind of mark what it says, as BlockWriter::Value gave it; 0: no mark.
  std::array<std::uint32_t, 6> marks{};
};

inline std::uint32_t& ValueOf(WritingState& state, MarkKind kind) {
  return state.marks[static_cast<std::size_t>(kind)];
}
inline std::uint32_t ValueOf(const WritingState& state, MarkKind kind) {
  return state.marks[static_cast<std::size_t>(kind)];
}

/// A place in the document: a block, and bytes of its text.
struct DocumentPlace {
  std::size_t block = kNoBlock;
  std::size_t offset = 0;
};

/// Writes text into the blocks of a document as it comes, word by word. Blanks become one space
/// each, also wide and hard ones that stand side by side, except in verbatim text; a block without
/// text does not come to be. Throws InputError (`name` and cause) for more than kMostBlocks.
class BlockWriter {
 public:
  /// Keeps a reference to the document.
  BlockWriter(Document& document, std::string name) : document_(document), name_(std::move(name)) {}

  /// Notes what a mark says; each call gives a mark of its own.
  std::uint32_t Value(std::string_view value);

  void Append(std::string_view text, const WritingState& state);
  /// A line's end within the block; a second one ends the block.
  void Break();
  /// A line of its own within the block, if one has begun.
  void BeginLine();
  /// Ends the block, if one has begun.
  void End();
  /// Of the next block that begins.
  void SetLabel(std::string label);
  /// The label that no block bears yet; none does then.
  std::string TakeLabel();
  /// An empty mark here, before what is written next. A picture begins a block as text does.
  void Point(MarkKind kind, std::string_view value, const WritingState& state);
  /// A block of no text of its own; its index.
  std::size_t Add(Block block);

  /// Whether the block that is being written ends with it so far.
  bool EndsWith(char c) const { return blank_.empty() && text_.text.ends_with(c); }
  DocumentPlace place() const { return {document_.blocks.size(), text_.text.size()}; }
  /// Bytes that were written so far, blanks apart.
  std::size_t written() const { return written_; }
  Document& document() { return document_; }
  const std::string& name() const { return name_; }

 private:
  void Put(std::string_view word, const WritingState& state);
  void PutBlank(std::string_view blank);
  void PutVerbatim(std::string_view text, const WritingState& state);
  void Begin(const WritingState& state);
  void Extend(const WritingState& state, std::size_t before, std::size_t begin);
  void Trim();

  Document& document_;
  std::string name_;
  Block text_;  // the block that is being written
  std::string label_;
  std::string blank_;  // that stands behind its last word, if another follows
  bool verbatim_ = false;
  struct OpenMark {
    std::size_t index = 0;
    std::uint32_t value = 0;
  };
  std::array<OpenMark, 6> open_{};
  std::vector<std::string> values_{""};
  std::size_t written_ = 0;
};

}  // namespace moontrace
