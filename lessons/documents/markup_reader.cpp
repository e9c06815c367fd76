#include "lessons/documents/markup_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include "lessons/documents/epub_package.h"
#include "textures/base/text_file.h"
#include "textures/base/utf8.h"

namespace moontrace {
namespace {

using Role = ElementRole;

constexpr std::size_t kDeepest = 5000;  // frames; deeper elements are read as their parent

bool IsBlock(Role role) {
  switch (role) {
    case Role::kInline:
    case Role::kSilent:
    case Role::kTitle:
    case Role::kMeta:
    case Role::kBreak:
    case Role::kQuote:
    case Role::kLink:
    case Role::kImage:
    case Role::kDrawing:
    case Role::kMath:
    case Role::kMedia:
    case Role::kReading:
    case Role::kRaised:
    case Role::kLowered:
    case Role::kInput:
    case Role::kSwitch:
      return false;
    case Role::kBlock:
    case Role::kHead:
    case Role::kHeading:
    case Role::kParagraph:
    case Role::kRule:
    case Role::kPreformatted:
    case Role::kQuotation:
    case Role::kList:
    case Role::kOrderedList:
    case Role::kItem:
    case Role::kTerm:
    case Role::kDefinition:
    case Role::kTable:
    case Role::kCaption:
    case Role::kTableHead:
    case Role::kRow:
    case Role::kCell:
    case Role::kHeaderCell:
      return true;
  }
  return false;
}

/// What it is by `epub:type` or `role`, in which "doc-" begins the same words.
bool HasType(const MarkupAttributes& attributes, const std::string& type) {
  return HasWord(attributes["epub:type"], type) || HasWord(attributes["role"], "doc-" + type);
}

/// Of notes, or of all of a chapter's. Books hide them so that reading systems show them where they
/// are called.
bool IsNote(const MarkupAttributes& attributes) {
  static const std::array<std::string, 6> kTypes = {"footnote",  "endnote",  "rearnote",
                                                    "footnotes", "endnotes", "rearnotes"};
  return std::any_of(kTypes.begin(), kTypes.end(),
                     [&](const std::string& type) { return HasType(attributes, type); });
}

bool IsVerse(const MarkupAttributes& attributes) {
  static constexpr std::array<std::string_view, 6> kWords = {"verse",  "poem",       "poetry",
                                                             "stanza", "line-block", "linegroup"};
  return std::any_of(kWords.begin(), kWords.end(), [&](std::string_view word) {
    return HasWord(attributes["class"], word) || HasWord(attributes["epub:type"], word);
  });
}

/// Of the number of a printed page by its look: as Project Gutenberg and DAISY's books have it.
bool IsPageNumber(ElementRole role, std::string_view name, const MarkupAttributes& attributes) {
  static constexpr std::array<std::string_view, 4> kWords = {"pagenum", "pageno", "pagenumber",
                                                             "page-number"};
  const bool holds_words = role == Role::kInline || role == Role::kBlock ||
                           role == Role::kParagraph ||
                           (role == Role::kLink && !attributes.Has("href"));
  return holds_words && (name == "pagenum" ||
                         std::any_of(kWords.begin(), kWords.end(), [&](std::string_view word) {
                           return HasWord(attributes["class"], word);
                         }));
}

/// Arabic or Roman.
bool IsNumber(std::string_view name) {
  return !name.empty() && (name.find_first_of("0123456789") != std::string_view::npos ||
                           LowerCase(name).find_first_not_of("ivxlcdm") == std::string::npos);
}

/// Lines of verse that stand together, each an element of its own.
bool IsStanza(std::string_view name, const MarkupAttributes& attributes) {
  return name == "linegroup" || HasWord(attributes["class"], "stanza") ||
         HasWord(attributes["class"], "linegroup") || HasWord(attributes["epub:type"], "stanza");
}

/// Digits and signs small and raised or lowered, as Unicode has them, so that 10 and 2 stay apart;
/// other text as it is.
std::string Shifted(std::string_view text, bool raised) {
  static constexpr std::array<char32_t, 10> kRaised = {0x2070, 0xB9,   0xB2,   0xB3,   0x2074,
                                                       0x2075, 0x2076, 0x2077, 0x2078, 0x2079};
  std::string shifted;
  for (const char c : text) {
    if (c >= '0' && c <= '9') {
      const auto digit = static_cast<std::size_t>(c - '0');
      shifted += ToUtf8(raised ? kRaised[digit] : static_cast<char32_t>(0x2080 + digit));
    } else if (c == '-' || c == '+') {
      shifted += ToUtf8((raised ? 0x207A : 0x208A) + (c == '-' ? 1U : 0U));
    } else if (c == ' ' || c == '\n' || c == '\t' || c == '\r') {
      shifted += c;
    } else {
      return std::string(text);
    }
  }
  return shifted;
}

/// Arrows up and back, by which a note leads to its call: no words, and no script has a sign for
/// them.
bool IsArrow(std::string_view text) {
  static constexpr std::u32string_view kArrows =
      U" \n^\u2191\u21A9\u21B5\u21B0\u21D1\u23CE\u2934\u2B06\uFE0E\uFE0F";
  const std::u32string signs = ToCodePoints(text);
  return std::all_of(signs.begin(), signs.end(),
                     [](char32_t c) { return kArrows.find(c) != std::u32string_view::npos; });
}

}  // namespace

void MarkupReader::BeginPart(std::string_view path) {
  path_ = path;
  frames_.clear();
  deeper_ = 0;
  lists_.clear();
  title_.clear();
  has_title_ = false;
  writer_.document().parts.push_back({path_, writer_.place().block});
  anchors_.push_back({path_ + "#", writer_.place()});
}

void MarkupReader::AlsoAt(std::string_view path) {
  anchors_.push_back({std::string(path) + "#", writer_.place()});
}

void MarkupReader::BeginEmbedded(std::string_view path) {
  outer_path_ = std::exchange(path_, std::string(path));
  anchors_.push_back({path_ + "#", writer_.place()});
}

void MarkupReader::EndPart() {
  while (!frames_.empty()) Close();
  writer_.End();
}

void MarkupReader::NoteAnchor(const MarkupAttributes& attributes) {
  for (const std::string_view name : {"id", "name"}) {
    const std::string_view id = attributes[name];
    if (!id.empty()) anchors_.push_back({path_ + "#" + std::string(id), writer_.place()});
  }
}

const DocumentPlace* MarkupReader::Find(std::string_view path, std::string_view id) const {
  for (; known_ < anchors_.size(); ++known_) found_.emplace(anchors_[known_].key, known_);
  const auto found = found_.find(std::string(path) + "#" + std::string(id));
  return found == found_.end() ? nullptr : &anchors_[found->second].place;
}

void MarkupReader::LeadLinks() const {
  Document& document = writer_.document();
  std::size_t block = 0;
  for (std::size_t part = 0; part < document.parts.size(); ++part) {
    const bool last = part + 1 == document.parts.size();
    const std::size_t end = last ? document.blocks.size() : document.parts[part + 1].first_block;
    for (; block < std::min(end, document.blocks.size()); ++block) {
      for (DocumentMark& mark : document.blocks[block].marks) {
        if (mark.kind != MarkKind::kLink && mark.kind != MarkKind::kNoteCall) continue;
        std::string id;
        const auto path = ResolvePath(document.parts[part].path, mark.value, &id);
        if (!path) continue;
        const DocumentPlace* place = Find(*path, id);
        if (place == nullptr && LowerCase(id) == "top") place = Find(*path, "");
        if (place != nullptr && place->block < document.blocks.size()) mark.target = place->block;
        // beside a single file lie other documents
        const bool within = document.format != DocumentFormat::kHtml || Find(*path, "") != nullptr;
        mark.missing = within && mark.target == kNoBlock;
      }
    }
  }
}

void MarkupReader::SetLanguage(Frame& frame, const MarkupAttributes& attributes) {
  const std::string_view own = attributes["xml:lang"];
  const std::string_view tag = own.empty() ? attributes["lang"] : own;
  if (tag.empty()) return;
  if (language_.empty() && writer_.written() == 0) language_ = tag;
  ValueOf(frame.state, MarkKind::kLanguage) = tag == language_ ? 0 : writer_.Value(tag);
}

/// Whether an element is a child of a switch that another one is read for.
bool MarkupReader::PassedOver(std::string_view name, const MarkupAttributes& attributes) {
  if (frames_.empty() || frames_.back().role != Role::kSwitch) return false;
  Frame& parent = frames_.back();
  const std::string& language = language_.empty() ? writer_.document().language : language_;
  if (parent.taken || !FitsInSwitch(name, attributes, language)) return true;
  parent.taken = true;
  return false;
}

/// True where nothing in the element is read.
bool MarkupReader::OpenSilent(Frame& frame, std::string_view name,
                              const MarkupAttributes& attributes) {
  if (IsHiddenElement(name, attributes) && frame.role != Role::kHead && !IsNote(attributes)) {
    frame.hidden = true;
    hidden_noted_ = false;
    if (frame.role == Role::kImage) NoteLeftOut(writer_.document(), LeftOut::kHiddenPart, "");
  }
  if (frame.role == Role::kHead) frame.in_head = true;
  frame.silent = frame.hidden || frame.in_head || frame.role == Role::kSilent ||
                 frame.role == Role::kReading ||
                 (frame.role == Role::kTitle && (!frame.drawing || frames_.back().labelled));
  return frame.silent;
}

void MarkupReader::Open(std::string_view name, const MarkupAttributes& attributes) {
  if (frames_.size() >= kDeepest) {
    ++deeper_;
    NoteLeftOut(writer_.document(), LeftOut::kDeepElement, name);
    return;
  }
  const bool passed_over = PassedOver(name, attributes);
  Frame frame;
  if (!frames_.empty()) {
    frame = frames_.back();
    frame.label = 0;
    frame.taken = frame.labelled = frame.apart = frame.line = false;
  }
  frame.silent = frame.silent || passed_over;
  frame.role = RoleOf(name, attributes);
  if (frame.role == Role::kRaised || frame.role == Role::kLowered) frame.shift = frame.role;
  frame.written = writer_.written();
  if (frame.silent || frame.page) {
    if (!frame.silent) {
      NoteAnchor(attributes);
      NotePageAnchor(attributes);
    }
    if (frame.role == Role::kMeta && frame.in_head && LowerCase(attributes["name"]) == "author") {
      writer_.document().authors.emplace_back(attributes["content"]);
    }
    frames_.push_back(frame);
    return;
  }
  if (math_) {
    math_->Open(name);
    ++math_depth_;
    frame.silent = frame.role == Role::kSilent;
    frames_.push_back(frame);
    return;
  }
  if (OpenSilent(frame, name, attributes)) {
    NoteAnchor(attributes);
  } else {
    OpenShown(frame, name, attributes);
  }
  frames_.push_back(frame);
}

/// An element whose text is read, or that stands among such text. `frame` is not yet open.
void MarkupReader::OpenShown(Frame& frame, std::string_view name,
                             const MarkupAttributes& attributes) {
  frame.line = IsLineOfVerse(frame, attributes);
  frame.stanza = IsStanza(name, attributes);
  frame.stand_in = frame.stand_in || name == "noscript";
  if (frame.line) {
    writer_.BeginLine();
  } else if (IsBlock(frame.role)) {
    writer_.End();
  }
  SetLanguage(frame, attributes);
  if (HasType(attributes, "footnote") || HasType(attributes, "endnote") ||
      HasType(attributes, "rearnote")) {
    frame.state.note = true;
  }
  if (name == "nav" && attributes.Has("epub:type")) frame.contents = true;
  if (IsVerse(attributes)) frame.state.kind = BlockKind::kVerse;
  OpenGroup(frame, name, attributes);
  OpenText(frame, name, attributes);
  NoteAnchor(attributes);
  if (HasType(attributes, "pagebreak")) {
    OpenPrintPage(frame, attributes);
  } else if (IsPageNumber(frame.role, name, attributes)) {
    frame.page = frame.maybe_page = true;
    page_name_.clear();
    page_title_.clear();
    page_placed_ = name == "pagenum";
    NotePageAnchor(attributes);
  }
}

/// A line of verse is no paragraph: it stands below the one before. `frame` is not yet open.
bool MarkupReader::IsLineOfVerse(const Frame& frame, const MarkupAttributes& attributes) const {
  if (frame.role != Role::kBlock && frame.role != Role::kParagraph) return false;
  if (frames_.empty() || frames_.back().state.kind != BlockKind::kVerse) return false;
  return frames_.back().stanza || HasWord(attributes["class"], "line");
}

void MarkupReader::OpenPrintPage(Frame& frame, const MarkupAttributes& attributes) {
  std::string_view said = attributes["title"];
  if (IsOnlyBlanks(said)) said = attributes["aria-label"];
  if (IsOnlyBlanks(said)) {
    frame.page = true;
    page_name_.clear();
    page_title_.clear();
  } else {
    const std::string name = PageName(said);
    writer_.Point(MarkKind::kPrintPage, name.empty() ? said : name, frame.state);
    frame.silent = true;
  }
}

/// What tells of a number that it is a page's: indexes and notes lead to it.
void MarkupReader::NotePageAnchor(const MarkupAttributes& attributes) {
  if (!attributes["id"].empty() || !attributes["name"].empty()) page_placed_ = true;
  if (page_title_.empty()) page_title_ = attributes["title"];
}

/// What only looks like a page's number is text: a table of contents has such numbers.
void MarkupReader::ClosePrintPage(const Frame& frame) {
  const std::string& said = IsOnlyBlanks(page_name_) ? page_title_ : page_name_;
  const std::string name = PageName(said);
  const bool marked = page_placed_ || said.find('[') != std::string::npos;
  if (frame.maybe_page && !(marked && IsNumber(name))) {
    Say(page_name_, frame.state);
  } else if (!IsOnlyBlanks(said)) {
    writer_.Point(MarkKind::kPrintPage, name.empty() ? said : name, frame.state);
  }
  if (IsBlock(frame.role)) writer_.End();
}

/// What holds blocks.
void MarkupReader::OpenGroup(Frame& frame, std::string_view name,
                             const MarkupAttributes& attributes) {
  switch (frame.role) {
    case Role::kHeading:
      frame.state.kind = BlockKind::kHeading;
      frame.state.level = static_cast<std::int16_t>(
          std::clamp(WholeNumber(attributes["aria-level"],
                                 name.size() == 2 && name[0] == 'h' ? name[1] - '0' : 2),
                     1, 6));
      return;
    case Role::kPreformatted:
      if (frame.state.kind != BlockKind::kVerse) frame.state.kind = BlockKind::kCode;
      frame.state.verbatim = true;
      return;
    case Role::kQuotation:
      frame.state.quotation = std::min<std::int16_t>(frame.state.quotation + 1, kMostLevels);
      return;
    case Role::kList:
    case Role::kOrderedList:
      BeginList(frame, attributes);
      return;
    case Role::kItem:
    case Role::kTerm:
    case Role::kDefinition:
      OpenItem(frame, attributes);
      return;
    case Role::kTable:
      PutLabel(frame.state);
      if (!tables_.empty()) tables_.back().SetLayout();
      tables_.emplace_back(writer_.place().block,
                           attributes["role"] == "presentation" || attributes["role"] == "none");
      table_anchors_.push_back(anchors_.size());
      return;
    case Role::kCaption:
      if (!tables_.empty()) tables_.back().BeginCaption(writer_.place().block);
      return;
    case Role::kRow:
      if (!tables_.empty()) tables_.back().BeginRow();
      return;
    case Role::kCell:
    case Role::kHeaderCell:
      if (!tables_.empty()) OpenCell(frame, attributes);
      return;
    default:
      return;
  }
}

/// What stands within a line, or alone.
void MarkupReader::OpenText(Frame& frame, std::string_view name,
                            const MarkupAttributes& attributes) {
  switch (frame.role) {
    case Role::kBreak:
      writer_.Break();
      return;
    case Role::kRule: {
      Block rule;
      rule.kind = BlockKind::kRule;
      rule.quotation = frame.state.quotation;
      writer_.Add(rule);
      return;
    }
    case Role::kQuote:
      Say("\xE2\x80\x9C", frame.state);
      return;
    case Role::kLink:
      OpenLink(frame, attributes);
      return;
    case Role::kImage:
      OpenImage(frame, attributes);
      return;
    case Role::kDrawing:
      OpenDrawing(frame, attributes);
      return;
    case Role::kMath:
      OpenMath(frame, attributes);
      return;
    case Role::kMedia:
      OpenMedia(frame, name, attributes);
      return;
    case Role::kInput:
      OpenInput(frame, attributes);
      return;
    default:
      if (frame.drawing) return OpenDrawn(frame, name, attributes);
      if (name == "button" && attributes.Has("aria-label")) {
        labels_.emplace_back(attributes["aria-label"]);
        frame.label = static_cast<std::uint32_t>(labels_.size() - 1);
      }
      return;
  }
}

void MarkupReader::OpenLink(Frame& frame, const MarkupAttributes& attributes) {
  if (!attributes.Has("href")) return;
  const bool note = HasType(attributes, "noteref");
  ValueOf(frame.state, note ? MarkKind::kNoteCall : MarkKind::kLink) =
      writer_.Value(attributes["href"]);
  frame.back = HasType(attributes, "backlink") || HasWord(attributes["class"], "footnote-back");
  std::string_view label = attributes["aria-label"];
  if (label.empty()) label = attributes["title"];
  if (label.empty() || frame.back) return;
  labels_.emplace_back(label);
  frame.label = static_cast<std::uint32_t>(labels_.size() - 1);
}

void MarkupReader::OpenMedia(Frame& frame, std::string_view name,
                             const MarkupAttributes& attributes) {
  std::string_view address = attributes["src"];
  if (address.empty()) address = attributes["data"];  // of an `object`
  if (read_embedded_ && outer_path_.empty() && !address.empty()) {
    const std::optional<std::string> path = ResolvePath(path_, address);
    frame.silent = path && *path != path_ && read_embedded_(*path);
  }
  if (!frame.silent) NoteLeftOut(writer_.document(), LeftOut::kMedia, name);
}

void MarkupReader::Text(std::string_view utf8) {
  if (frames_.empty()) {
    Say(utf8, {});
    return;
  }
  const Frame& frame = frames_.back();
  if (frame.page) {
    page_name_ += utf8;
  } else if (frame.hidden) {
    if (!hidden_noted_ && !IsOnlyBlanks(utf8)) {
      NoteLeftOut(writer_.document(), LeftOut::kHiddenPart, utf8);
      hidden_noted_ = true;
    }
  } else if (frame.in_head && frame.role == Role::kTitle && !has_title_) {
    title_ += utf8;
  } else if (frame.role == Role::kReading) {
    if (!IsOnlyBlanks(utf8) && utf8 != "(" && utf8 != ")") {
      NoteLeftOut(writer_.document(), LeftOut::kReading, utf8);
    }
  } else if (frame.silent || (frame.back && IsArrow(utf8))) {
    return;
  } else if (math_) {
    math_->Text(utf8);
  } else if (frame.drawing && frame.role == Role::kTitle) {
    if (drawing_title_.empty()) drawing_title_ = utf8;
    Say(utf8, frame.state);
  } else if (frame.shift == Role::kLowered) {
    Say(Shifted(utf8, false), frame.state);
  } else if (frame.shift == Role::kRaised || ValueOf(frame.state, MarkKind::kNoteCall) != 0) {
    // in brackets it is apart already
    Say(writer_.EndsWith('[') ? std::string(utf8) : Shifted(utf8, true), frame.state);
  } else {
    Say(utf8, frame.state);
  }
}

void MarkupReader::UnknownEntity(std::string_view name) {
  NoteLeftOut(writer_.document(), LeftOut::kUnknownEntity, name);
}

void MarkupReader::Fault(std::string_view what) {
  NoteLeftOut(writer_.document(), LeftOut::kFaultyPart, what);
}

void MarkupReader::CloseLink(const Frame& frame) {
  if (frame.label != 0 && writer_.written() == frame.written) {
    Say(labels_[frame.label], frame.state);
  }
}

void MarkupReader::Close() {
  if (deeper_ > 0) {
    --deeper_;
    return;
  }
  if (frames_.empty()) return;
  const Frame frame = frames_.back();
  frames_.pop_back();
  if (math_ && math_depth_ > 0) {
    --math_depth_;
    math_->Close();
    return;
  }
  if (math_) {
    const std::string words = IsOnlyBlanks(math_->text()) ? math_words_ : math_->text();
    math_.reset();
    Say(words, frame.state);
    return;
  }
  const bool outer_page = !frames_.empty() && frames_.back().page;
  if (frame.page && !outer_page) return ClosePrintPage(frame);
  if (frame.role == Role::kTitle && frame.in_head) has_title_ = true;
  if (frame.silent || frame.page) return;
  if (IsBlock(frame.role) && !frame.line) writer_.End();
  if (frame.role == Role::kItem || frame.role == Role::kDefinition) writer_.SetLabel("");
  if (frame.role == Role::kList || frame.role == Role::kOrderedList) CloseList();
  if (frame.role == Role::kTable) CloseTable();
  if (frame.role == Role::kCaption && !tables_.empty()) {
    tables_.back().EndCaption(writer_.place().block);
  }
  if ((frame.role == Role::kCell || frame.role == Role::kHeaderCell) && !tables_.empty()) {
    tables_.back().EndCell(writer_.place().block);
  }
  if (frame.role == Role::kQuote) Say("\xE2\x80\x9D", frame.state);
  if (frame.apart) Say(" ", frame.state);
  if (frame.role == Role::kDrawing) CloseDrawing(frame);
  CloseLink(frame);
}

}  // namespace moontrace
