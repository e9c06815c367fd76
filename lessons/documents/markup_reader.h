#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "lessons/documents/block_writer.h"
#include "lessons/documents/markup_elements.h"
#include "lessons/documents/math_text.h"
#include "lessons/documents/table_reader.h"

namespace moontrace {

/// Makes blocks of HTML's elements, whichever parser found them, part after part of a document.
/// Read as a screen reader does: hidden parts are passed over, pictures are their alternative text
/// (none: an empty mark), lists and tables tell their size. Throws InputError as BlockWriter does.
class MarkupReader : public MarkupSink {
 public:
  explicit MarkupReader(BlockWriter& writer) : writer_(writer) {}

  /// Reads a page within the page in its place, by its path in the book, with BeginEmbedded and
  /// EndEmbedded around it; false where the book has no such page, which is then left out.
  void ReadEmbeddedBy(std::function<bool(const std::string& path)> read) {
    read_embedded_ = std::move(read);
  }
  void BeginEmbedded(std::string_view path);
  void EndEmbedded() { path_ = std::exchange(outer_path_, {}); }

  /// `path` of the part within the book, for places that are named in it.
  void BeginPart(std::string_view path);
  /// Another path that leads to where the next part begins: of what it stands in for.
  void AlsoAt(std::string_view path);
  void EndPart();

  void Open(std::string_view name, const MarkupAttributes& attributes) override;
  void Text(std::string_view utf8) override;
  void Close() override;
  void UnknownEntity(std::string_view name) override;
  void Fault(std::string_view what) override;

  /// Behind the last part: what the document's links lead to within it.
  void LeadLinks() const;

  /// The title of the part's head.
  const std::string& title() const { return title_; }
  const std::string& language() const { return language_; }
  /// A place of a part by the id of its element, or the part's beginning for an empty one.
  const DocumentPlace* Find(std::string_view path, std::string_view id) const;

 private:
  static constexpr std::int16_t kMostLevels = 100;  // of lists and quotations
  struct Frame {
    ElementRole role = ElementRole::kInline;
    WritingState state;
    bool silent = false, hidden = false, drawing = false, in_head = false;
    bool page = false;        // its text is the name of a print page
    bool maybe_page = false;  // by its look only
    bool taken = false;       // of a switch: one of its children is read
    bool labelled = false;    // of a drawing: its title would say the same again
    bool apart = false;       // words of their own in a drawing
    bool contents = false;    // in a table of contents of EPUB: its lists have no numbers
    bool line = false;        // of verse, and no paragraph
    bool stand_in = false;    // for browsers without scripts
    bool stanza = false;      // its blocks are such lines
    bool back = false;        // leads from a note to its call
    ElementRole shift = ElementRole::kInline;  // kRaised or kLowered, of all that is in it

    std::uint32_t label = 0;  // of a link, in labels_
    std::size_t written = 0;  // when it began
  };
  struct OpenList {
    std::size_t block = 0;
    bool ordered = false;
    char type = '1';
    int next = 1, step = 1;
    std::uint32_t items = 0;
    bool from_end = false;  // numbers count down to 1: they are known once it closes
    std::vector<std::pair<std::size_t, int>> counted;  // such items: next block, number from 0
  };
  struct Anchor {
    std::string key;
    DocumentPlace place;
  };

  bool PassedOver(std::string_view name, const MarkupAttributes& attributes);
  bool OpenSilent(Frame& frame, std::string_view name, const MarkupAttributes& attributes);
  void OpenShown(Frame& frame, std::string_view name, const MarkupAttributes& attributes);
  bool IsLineOfVerse(const Frame& frame, const MarkupAttributes& attributes) const;
  void OpenPrintPage(Frame& frame, const MarkupAttributes& attributes);
  void NotePageAnchor(const MarkupAttributes& attributes);
  void ClosePrintPage(const Frame& frame);
  void OpenText(Frame& frame, std::string_view name, const MarkupAttributes& attributes);
  void OpenGroup(Frame& frame, std::string_view name, const MarkupAttributes& attributes);
  void PutLabel(const WritingState& state);
  void BeginList(Frame& frame, const MarkupAttributes& attributes);
  void OpenItem(Frame& frame, const MarkupAttributes& attributes);
  void OpenCell(Frame& frame, const MarkupAttributes& attributes);
  void OpenImage(const Frame& frame, const MarkupAttributes& attributes);
  void OpenDrawing(Frame& frame, const MarkupAttributes& attributes);
  void OpenDrawn(Frame& frame, std::string_view name, const MarkupAttributes& attributes);
  void OpenMedia(Frame& frame, std::string_view name, const MarkupAttributes& attributes);
  void OpenMath(Frame& frame, const MarkupAttributes& attributes);
  void OpenInput(const Frame& frame, const MarkupAttributes& attributes);
  void OpenLink(Frame& frame, const MarkupAttributes& attributes);
  void CloseTable();
  void CountDown(const OpenList& list);
  void CloseList();
  void CloseLink(const Frame& frame);
  void CloseDrawing(const Frame& frame);
  void SetLanguage(Frame& frame, const MarkupAttributes& attributes);
  void NoteAnchor(const MarkupAttributes& attributes);
  void Say(std::string_view text, const WritingState& state) { writer_.Append(text, state); }

  BlockWriter& writer_;
  std::function<bool(const std::string& path)> read_embedded_;
  std::string path_;
  std::string outer_path_;  // of the page around the one that is read; empty: there is none
  std::vector<Frame> frames_;
  std::size_t deeper_ = 0;  // elements below the deepest frame
  std::vector<OpenList> lists_;
  std::vector<TableReader> tables_;
  std::optional<MathText> math_;
  std::size_t math_depth_ = 0;
  std::string math_words_;  // where the formula has no other
  std::string title_, language_, page_name_, page_title_;
  bool page_placed_ = false;     // something leads to the page's number
  std::string picture_;          // words of the last one
  std::size_t picture_end_ = 0;  // bytes that were written up to its end
  std::string drawing_title_;    // of the drawing that is open
  bool has_title_ = false;
  bool hidden_noted_ = false;
  std::vector<std::string> labels_{""};
  std::vector<Anchor> anchors_;
  std::vector<std::size_t> table_anchors_;  // how many there were when each table began
  mutable std::unordered_map<std::string, std::size_t> found_;  // by key, the first in anchors_
  mutable std::size_t known_ = 0;                               // anchors that are in it
};

}  // namespace moontrace
