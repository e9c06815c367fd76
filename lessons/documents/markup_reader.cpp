#include "lessons/documents/markup_reader.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "lessons/documents/epub_package.h"
#include "textures/base/text_file.h"
#include "textures/base/utf8.h"

namespace moontrace {
namespace {

using Role = ElementRole;

constexpr std::size_t kDeepest = 5000;  // frames; deeper elements are read as their parent
constexpr std::int16_t kMostLevels = 100;
constexpr int kNoNumber = std::numeric_limits<int>::min();

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

std::uint32_t& ValueOf(WritingState& state, MarkKind kind) {
  return state.marks[static_cast<std::size_t>(kind)];
}
std::uint32_t ValueOf(const WritingState& state, MarkKind kind) {
  return state.marks[static_cast<std::size_t>(kind)];
}

bool IsBlank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n\f") == std::string_view::npos;
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

/// 1 is "a", 27 is "aa"; `first` is the small letter or the capital.
std::string InLetters(int number, char first) {
  std::string letters;
  for (; number > 0; number = (number - 1) / 26) {
    letters.insert(letters.begin(), static_cast<char>(first + (number - 1) % 26));
  }
  return letters;
}

/// 4 is "iv".
std::string InRoman(int number, bool capitals) {
  static constexpr std::array<std::pair<int, const char*>, 13> kParts = {{{1000, "m"},
                                                                          {900, "cm"},
                                                                          {500, "d"},
                                                                          {400, "cd"},
                                                                          {100, "c"},
                                                                          {90, "xc"},
                                                                          {50, "l"},
                                                                          {40, "xl"},
                                                                          {10, "x"},
                                                                          {9, "ix"},
                                                                          {5, "v"},
                                                                          {4, "iv"},
                                                                          {1, "i"}}};
  std::string roman;
  for (const auto& [value, letters] : kParts) {
    for (; number >= value; number -= value) roman += letters;
  }
  if (!capitals) return roman;
  for (char& c : roman) c = static_cast<char>(c - 'a' + 'A');
  return roman;
}

/// As the list's type has it (HTML, 4.4.5); `kBare`: without.
constexpr char kBare = ' ';
std::string NumberLabel(int number, char type) {
  constexpr int kMostRoman = 3999;
  if (type == kBare) return {};
  std::string label = std::to_string(number);
  if ((type == 'a' || type == 'A') && number > 0) label = InLetters(number, type);
  const bool roman = type == 'i' || type == 'I';
  if (roman && number > 0 && number <= kMostRoman) label = InRoman(number, type == 'I');
  return label + ".";
}

/// How the items of a list are numbered, by its own style or its attribute.
char NumberType(const MarkupAttributes& attributes) {
  static constexpr std::array<std::pair<std::string_view, char>, 7> kStyles = {
      {{"lower-alpha", 'a'},
       {"lower-latin", 'a'},
       {"upper-alpha", 'A'},
       {"upper-latin", 'A'},
       {"lower-roman", 'i'},
       {"upper-roman", 'I'},
       {"none", kBare}}};
  const std::string style = LowerCase(attributes["style"].substr(0, 4096));
  if (const std::size_t at = style.find("list-style"); at != std::string::npos) {
    const std::string value = style.substr(at, style.find(';', at) - at);
    for (const auto& [name, type] : kStyles) {
      if (value.find(name) != std::string::npos) return type;
    }
  }
  const std::string_view type = attributes["type"];
  return type.size() == 1 && std::string_view("aAiI").find(type) != std::string::npos ? type[0]
                                                                                      : '1';
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

/// Whether a part of a drawing's text begins a line of its own.
bool BeginsLine(std::string_view name, const MarkupAttributes& attributes) {
  return name == "tspan" && (attributes.Has("y") ||
                             attributes["dy"].find_first_of("123456789") != std::string_view::npos);
}

/// "a/b/cover.jpg?x" is "cover.jpg".
std::string_view FileName(std::string_view address) {
  if (address.substr(0, 5) == "data:") return "";
  address = address.substr(0, address.find_first_of("?#"));
  const std::size_t slash = address.find_last_of('/');
  return slash == std::string_view::npos ? address : address.substr(slash + 1);
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
    frames_.push_back(frame);
    return;
  }
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
  frames_.push_back(frame);
}

/// A line of verse is no paragraph: it stands below the one before. `frame` is not yet open.
bool MarkupReader::IsLineOfVerse(const Frame& frame, const MarkupAttributes& attributes) const {
  if (frame.role != Role::kBlock && frame.role != Role::kParagraph) return false;
  if (frames_.empty() || frames_.back().state.kind != BlockKind::kVerse) return false;
  return frames_.back().stanza || HasWord(attributes["class"], "line");
}

void MarkupReader::OpenPrintPage(Frame& frame, const MarkupAttributes& attributes) {
  std::string_view said = attributes["title"];
  if (IsBlank(said)) said = attributes["aria-label"];
  if (IsBlank(said)) {
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
  const std::string& said = IsBlank(page_name_) ? page_title_ : page_name_;
  const std::string name = PageName(said);
  const bool marked = page_placed_ || said.find('[') != std::string::npos;
  if (frame.maybe_page && !(marked && IsNumber(name))) {
    Say(page_name_, frame.state);
  } else if (!IsBlank(said)) {
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

void MarkupReader::BeginList(Frame& frame, const MarkupAttributes& attributes) {
  frame.state.level = 0;
  OpenList list;
  list.ordered = frame.role == Role::kOrderedList && !frame.contents;
  const bool reversed = attributes.Has("reversed");
  list.step = reversed ? -1 : 1;
  list.next = WholeNumber(attributes["start"], reversed ? kNoNumber : 1);
  list.from_end = list.next == kNoNumber;
  if (list.from_end) list.next = 0;
  list.type = NumberType(attributes);
  PutLabel(frames_.empty() ? frame.state : frames_.back().state);
  Block block;
  block.kind = BlockKind::kList;
  block.level = static_cast<int>(std::min<std::size_t>(lists_.size() + 1, kMostLevels));
  block.quotation = frame.state.quotation;
  list.block = writer_.Add(std::move(block));
  lists_.push_back(std::move(list));
}

/// The number of an item that begins with a list or a table: it would be lost, or be taken for the
/// first number in it.
void MarkupReader::PutLabel(const WritingState& state) {
  Block item;
  item.label = writer_.TakeLabel();
  if (item.label.empty() || item.label == "-") return;
  item.kind = BlockKind::kListItem;
  item.level = state.level;
  item.quotation = state.quotation;
  item.note = state.note;
  writer_.Add(std::move(item));
}

void MarkupReader::OpenItem(Frame& frame, const MarkupAttributes& attributes) {
  frame.state.kind = BlockKind::kListItem;
  frame.state.level =
      static_cast<std::int16_t>(std::clamp<std::size_t>(lists_.size(), 1, kMostLevels));
  if (lists_.empty()) {
    writer_.SetLabel("-");
    return;
  }
  OpenList& list = lists_.back();
  if (frame.role != Role::kDefinition) ++list.items;
  if (frame.role == Role::kTerm) return;
  if (!list.ordered) {
    writer_.SetLabel("-");
    return;
  }
  const int own = WholeNumber(attributes["value"], kNoNumber);
  if (own != kNoNumber) list.from_end = false;
  const int number = own != kNoNumber ? own : list.next;
  const bool bare = NumberType(attributes) == kBare;
  const std::string label = NumberLabel(number, bare ? kBare : list.type);
  if (list.from_end) list.counted.push_back({writer_.place().block, number});
  writer_.SetLabel(label);
  list.next = number + list.step;
}

void MarkupReader::OpenCell(Frame& frame, const MarkupAttributes& attributes) {
  TableCell cell;
  cell.header = frame.role == Role::kHeaderCell;
  const std::string scope = LowerCase(attributes["scope"]);
  cell.names_row = scope == "row" || scope == "rowgroup";
  cell.names_column = scope == "col" || scope == "colgroup";
  cell.columns = static_cast<std::uint32_t>(std::max(WholeNumber(attributes["colspan"], 1), 1));
  cell.first_block = cell.end_block = writer_.place().block;
  cell.rows =
      static_cast<std::uint32_t>(std::clamp(WholeNumber(attributes["rowspan"], 1), 1, 65534));
  tables_.back().BeginCell(cell);
  frame.state.kind = BlockKind::kParagraph;
  frame.state.level = 0;
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

void MarkupReader::OpenImage(const Frame& frame, const MarkupAttributes& attributes) {
  const std::string_view role = attributes["role"];
  if (role == "presentation" || role == "none") return;
  std::string_view words = attributes["aria-label"];
  if (words.empty()) words = attributes["alt"];
  if (words.empty()) words = attributes["title"];
  const std::string_view file = FileName(attributes["src"]);
  const bool again = frame.stand_in && picture_end_ == writer_.written() && picture_ == words;
  if (again) return;
  const auto note = [&] {
    picture_ = words;
    picture_end_ = writer_.written();
  };
  if (!IsBlank(words)) {
    WritingState state = frame.state;
    ValueOf(state, MarkKind::kPicture) = writer_.Value(file);
    state.verbatim = false;
    Say(words, state);
    note();
    const bool drawing = LowerCase(file).ends_with(".svg");
    if (drawing) NoteLeftOut(writer_.document(), LeftOut::kDrawing, words);
  } else if (!attributes.Has("alt")) {  // an empty one says that it only decorates
    writer_.Point(MarkKind::kPicture, file, frame.state);
    note();
    NoteLeftOut(writer_.document(), LeftOut::kPicture, file);
  }
}

void MarkupReader::OpenDrawing(Frame& frame, const MarkupAttributes& attributes) {
  const bool inner = frame.drawing;
  frame.drawing = true;
  if (!inner) {
    ValueOf(frame.state, MarkKind::kPicture) = writer_.Value("");
    drawing_title_.clear();
  }
  OpenDrawn(frame, "svg", attributes);
}

/// An element in a drawing: its words stand apart from those of others, as they do on paper.
void MarkupReader::OpenDrawn(Frame& frame, std::string_view name,
                             const MarkupAttributes& attributes) {
  const std::string_view label = attributes["aria-label"];
  frame.labelled = !IsBlank(label);
  frame.apart = frame.labelled || name == "title" || name == "desc" || name == "text" ||
                BeginsLine(name, attributes);
  if (frame.apart) Say(" ", frame.state);
  if (!frame.labelled) return;
  if (drawing_title_.empty()) drawing_title_ = label;
  Say(label, frame.state);
  Say(" ", frame.state);
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

void MarkupReader::OpenMath(Frame& frame, const MarkupAttributes& attributes) {
  ValueOf(frame.state, MarkKind::kMath) = writer_.Value("");
  const std::string_view words = attributes["alttext"];
  const bool tex = words.find('\\') != std::string_view::npos;  // for programs, not to be said
  if (!IsBlank(words) && !tex) {
    Say(words, frame.state);
    frame.silent = true;
    return;
  }
  math_words_ = words;
  math_.emplace();
  math_depth_ = 0;
}

void MarkupReader::OpenInput(const Frame& frame, const MarkupAttributes& attributes) {
  const std::string type = LowerCase(attributes["type"]);
  if (type == "checkbox" || type == "radio" || type == "password") return;
  for (const char* name : {"value", "alt", "placeholder", "aria-label"}) {
    if (IsBlank(attributes[name])) continue;
    Say(" ", frame.state);
    Say(attributes[name], frame.state);
    Say(" ", frame.state);
    return;
  }
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
    if (!hidden_noted_ && !IsBlank(utf8)) {
      NoteLeftOut(writer_.document(), LeftOut::kHiddenPart, utf8);
      hidden_noted_ = true;
    }
  } else if (frame.in_head && frame.role == Role::kTitle && !has_title_) {
    title_ += utf8;
  } else if (frame.role == Role::kReading) {
    if (!IsBlank(utf8) && utf8 != "(" && utf8 != ")") {
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

void MarkupReader::CloseTable() {
  const TableReader table = std::move(tables_.back());
  tables_.pop_back();
  const std::size_t first = table.first_block();
  const std::vector<std::size_t> now = table.Finish(writer_.document());
  for (std::size_t i = table_anchors_.back(); i < anchors_.size(); ++i) {
    DocumentPlace& place = anchors_[i].place;
    const std::size_t moved = place.block - first < now.size() ? now[place.block - first] : 0;
    if (moved == place.block || moved == 0) continue;
    place = {moved, 0};
  }
  table_anchors_.pop_back();
}

/// Items of a reversed list without a start, which were counted down from 0: now their number is
/// known (HTML, 4.4.5). An item without text has no block that bears its label; it is not sought
/// far, since lists may be nested deep.
void MarkupReader::CountDown(const OpenList& list) {
  std::vector<Block>& blocks = writer_.document().blocks;
  for (std::size_t i = 0; i < list.counted.size(); ++i) {
    constexpr std::size_t kNear = 8;
    const auto [first, number] = list.counted[i];
    const std::size_t end = i + 1 < list.counted.size() ? list.counted[i + 1].first : blocks.size();
    const std::string label = NumberLabel(number, list.type);
    for (std::size_t b = first; b < std::min({end, blocks.size(), first + kNear}); ++b) {
      if (blocks[b].label != label) continue;
      blocks[b].label = NumberLabel(number + static_cast<int>(list.items), list.type);
      break;
    }
  }
}

void MarkupReader::CloseList() {
  const OpenList list = std::move(lists_.back());
  lists_.pop_back();
  CountDown(list);
  std::vector<Block>& blocks = writer_.document().blocks;
  if (list.block + 1 == blocks.size()) {
    blocks.pop_back();  // a list of nothing
  } else {
    blocks[list.block].row = list.items;
  }
}

void MarkupReader::CloseLink(const Frame& frame) {
  if (frame.label != 0 && writer_.written() == frame.written) {
    Say(labels_[frame.label], frame.state);
  }
}

void MarkupReader::CloseDrawing(const Frame& frame) {
  if (!frames_.empty() && frames_.back().drawing) return;  // within another
  if (writer_.written() != frame.written) {
    return NoteLeftOut(writer_.document(), LeftOut::kDrawing, drawing_title_);
  }
  writer_.Point(MarkKind::kPicture, "", frame.state);
  NoteLeftOut(writer_.document(), LeftOut::kPicture, "svg");
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
    const std::string words = IsBlank(math_->text()) ? math_words_ : math_->text();
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
