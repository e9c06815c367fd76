#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// What a document holds, in reading order: a list of blocks with marks on their words, whatever
/// format it came from. Plain values; texts are UTF-8, offsets are bytes.

/// kList and kTable stand before their items and cells and tell how many there are; the text of a
/// table is its caption. Lines of kVerse and kCode count, and so do the line ends that a kParagraph
/// has. kRule is a break between scenes, without text.
enum class BlockKind : std::uint8_t {
  kParagraph,
  kHeading,
  kList,
  kListItem,
  kTable,
  kCell,
  kVerse,
  kCode,
  kRule
};

constexpr std::string_view NameOf(BlockKind kind) {
  switch (kind) {
    case BlockKind::kParagraph:
      return "paragraph";
    case BlockKind::kHeading:
      return "heading";
    case BlockKind::kList:
      return "list";
    case BlockKind::kListItem:
      return "item";
    case BlockKind::kTable:
      return "table";
    case BlockKind::kCell:
      return "cell";
    case BlockKind::kVerse:
      return "verse";
    case BlockKind::kCode:
      return "code";
    case BlockKind::kRule:
      return "break";
  }
  return {};
}

/// kPicture lies on the words that stand for a picture, and is empty where there are none;
/// kPrintPage is empty and stands where a page of the printed book begins.
enum class MarkKind : std::uint8_t { kLink, kNoteCall, kPicture, kMath, kLanguage, kPrintPage };

constexpr std::string_view NameOf(MarkKind kind) {
  switch (kind) {
    case MarkKind::kLink:
      return "link";
    case MarkKind::kNoteCall:
      return "note call";
    case MarkKind::kPicture:
      return "picture";
    case MarkKind::kMath:
      return "mathematics";
    case MarkKind::kLanguage:
      return "language";
    case MarkKind::kPrintPage:
      return "print page";
  }
  return {};
}

constexpr std::size_t kNoBlock = static_cast<std::size_t>(-1);

/// Something about a range of a block's text.
struct DocumentMark {
  MarkKind kind = MarkKind::kLink;
  std::size_t begin = 0, end = 0;  ///< bytes of the block's text
  std::string value;  ///< address, file of the picture, language tag, name of the print page
  std::size_t target = kNoBlock;  ///< of a link and a note call: the block that it leads to
  bool missing = false;           ///< likewise: it leads within the document, to what is not there
  bool operator==(const DocumentMark&) const = default;
};

struct Block {
  BlockKind kind = BlockKind::kParagraph;
  bool note = false;  ///< of a footnote or endnote
  int level = 0;      ///< of a heading 1-6; of a list and its items 1 and up
  int quotation = 0;  ///< in so many quotations
  std::string text;
  /// Of an item its number or sign, of later paragraphs in it empty; of a cell its row's name.
  std::string label;
  std::string column_name;  ///< of a cell; of a table all of them
  std::uint32_t row = 0;  ///< of a cell, from 1 below the headings; of a table and a list how many
  std::uint32_t column = 0;
  std::vector<DocumentMark> marks;  ///< by `begin`
};

/// A file of the document: the file itself, or a chapter's in a book.
struct DocumentPart {
  std::string path;             ///< within the book; empty for a single file
  std::size_t first_block = 0;  ///< may be behind the last one
};

/// A line of a table of contents.
struct ContentsEntry {
  std::string title;
  int level = 1;
  std::size_t block = kNoBlock;  ///< where it leads; kNoBlock: nowhere in this document
  /// It names the lines below it and has no link of its own: it leads where the first of them does.
  bool group = false;
};

/// What a document shows and its blocks lack, or have otherwise.
enum class LeftOut : std::uint8_t {
  kHiddenPart,     ///< made invisible by its author: not read
  kPicture,        ///< without alternative text
  kDrawing,        ///< made of lines (SVG): its words are read, its lines are not felt
  kMedia,          ///< sound, video, programs, pages within the page
  kReading,        ///< small characters beside others that tell how they are spoken
  kGuessedCoding,  ///< nothing says its encoding: the likeliest one was taken
  kBadByte,        ///< of no character in its encoding: U+FFFD stands there
  kUnknownEntity,  ///< "&name;" of an unknown name: left as it is
  kDeepElement,    ///< nested too deep: its text is kept, its kind is not
  kFaultyPart,   ///< its names are faulty as XML (namespaces, attributes twice): read all the same
  kBrokenPart,   ///< not well-formed: read as web pages are
  kMissingPart,  ///< named by the book and not in it
  kStandIn,      ///< a chapter made by a script: its stand-in is read
  kUnreadablePart,  ///< a chapter that is no text, and nothing stands in for it
  kOutsidePart,     ///< its address leaves the book
  kEncryptedPart,   ///< a picture or the like: not needed
  kBrokenContents,  ///< a table of contents that is not well-formed
  kLaterPart        ///< outside of the reading order: stands at the end
};

constexpr std::string_view NameOf(LeftOut what) {
  switch (what) {
    case LeftOut::kHiddenPart:
      return "hidden";
    case LeftOut::kPicture:
      return "picture";
    case LeftOut::kDrawing:
      return "drawing";
    case LeftOut::kMedia:
      return "media";
    case LeftOut::kReading:
      return "reading";
    case LeftOut::kGuessedCoding:
      return "guessed encoding";
    case LeftOut::kBadByte:
      return "bad byte";
    case LeftOut::kUnknownEntity:
      return "unknown entity";
    case LeftOut::kDeepElement:
      return "deep element";
    case LeftOut::kFaultyPart:
      return "faulty part";
    case LeftOut::kBrokenPart:
      return "broken part";
    case LeftOut::kMissingPart:
      return "missing part";
    case LeftOut::kStandIn:
      return "stand-in";
    case LeftOut::kUnreadablePart:
      return "unreadable part";
    case LeftOut::kOutsidePart:
      return "part outside the book";
    case LeftOut::kEncryptedPart:
      return "encrypted part";
    case LeftOut::kBrokenContents:
      return "broken contents";
    case LeftOut::kLaterPart:
      return "part outside the order";
  }
  return {};
}

/// How often, and the first of them.
struct LeftOutCount {
  LeftOut what = LeftOut::kPicture;
  std::size_t count = 0;
  std::string example;  ///< a name or a text, foreign; may be empty
};

enum class DocumentFormat : std::uint8_t { kText, kHtml, kEpub, kBrf, kEBraille };

constexpr std::string_view NameOf(DocumentFormat format) {
  switch (format) {
    case DocumentFormat::kText:
      return "text";
    case DocumentFormat::kHtml:
      return "HTML";
    case DocumentFormat::kEpub:
      return "EPUB";
    case DocumentFormat::kBrf:
      return "BRF";
    case DocumentFormat::kEBraille:
      return "eBraille";
  }
  return {};
}

struct Document {
  DocumentFormat format = DocumentFormat::kText;
  std::string title;  ///< empty: none is given
  std::vector<std::string> authors;
  std::string language;  ///< its tag, such as "en-GB"; empty: not told
  std::string encoding;  ///< of a single file, as it was read
  std::vector<DocumentPart> parts;
  std::vector<Block> blocks;
  std::vector<ContentsEntry> contents;  ///< the document's own; see ContentsOf
  std::vector<LeftOutCount> left_out;   ///< by `what`, each at most once
};

/// Counts one more, and keeps the first example.
void NoteLeftOut(Document& document, LeftOut what, std::string_view example, std::size_t count = 1);

/// Its own table of contents; where it has none, its headings.
std::vector<ContentsEntry> ContentsOf(const Document& document);

/// Largest document that is taken.
struct DocumentLimits {
  std::size_t most_bytes = std::size_t{64} << 20;  ///< of a file; of all parts of a book, unpacked
};
/// Blocks of a document [number], so that memory is bounded.
constexpr std::size_t kMostBlocks = 1'000'000;
/// Elements of one file of HTML or XML, and attributes of one element [number].
constexpr std::size_t kMostElements = 2'000'000;

}  // namespace moontrace
