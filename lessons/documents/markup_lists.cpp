// Lists and tables of a document, as MarkupReader meets them.
#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>

#include "lessons/documents/markup_reader.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

using Role = ElementRole;

constexpr int kNoNumber = std::numeric_limits<int>::min();

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

}  // namespace

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

}  // namespace moontrace
