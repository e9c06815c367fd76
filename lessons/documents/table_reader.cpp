#include "lessons/documents/table_reader.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace moontrace {
namespace {

constexpr std::uint32_t kMostColumns = 1000;  // HTML's limit of a span
constexpr std::size_t kLongestName = 200;     // [bytes]; ours
constexpr std::size_t kMostAgain = 32768;     // told again, and four times the table's; ours
constexpr std::size_t kCellSize = 16;         // that a cell counts beside its text; ours

/// Blocks of a cell as one, its paragraphs lines of it.
Block Joined(const std::vector<Block>& blocks, std::size_t first, std::size_t end) {
  Block cell;
  for (std::size_t i = first; i < end; ++i) {
    const Block& block = blocks[i];
    if (block.text.empty() && block.marks.empty() && block.label.empty())
      continue;  // that a list begins
    if (!cell.text.empty()) cell.text += '\n';
    if (!block.label.empty()) cell.text += block.label + (block.text.empty() ? "" : " ");
    const std::size_t shift = cell.text.size();
    cell.text += block.text;
    for (DocumentMark mark : block.marks) {
      mark.begin += shift;
      mark.end += shift;
      cell.marks.push_back(std::move(mark));
    }
    cell.note |= block.note;
    cell.quotation = std::max(cell.quotation, block.quotation);
  }
  cell.kind = BlockKind::kCell;
  return cell;
}

/// A page of the printed book begins once.
bool IsPrintPage(const DocumentMark& mark) { return mark.kind == MarkKind::kPrintPage; }

std::string OneLineOf(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

void AppendName(std::string& name, const std::string& more) {
  if (more.empty()) return;
  if (!name.empty()) name += ' ';
  name += more;
}

/// Names are told with every cell: a long one is a cell itself.
bool HasRoom(const std::string& name, const std::string& more) {
  return name.size() + more.size() <= kLongestName;
}

/// A table's cells put together, and the names that its headers give.
struct Grid {
  std::vector<Block> cells;  // as the TableCells
  std::vector<bool> names;   // whether a cell is only a name
  std::vector<std::string> columns, rows;
  std::uint32_t head_rows = 0;  // at the top, that only name columns
};

/// Rows at the top whose cells are all headers name columns; headers elsewhere name their row.
Grid NamedGrid(const std::vector<TableCell>& places, std::vector<Block> cells, std::uint32_t rows,
               std::uint32_t columns) {
  Grid grid{std::move(cells), std::vector<bool>(places.size(), false),
            std::vector<std::string>(columns), std::vector<std::string>(rows)};
  std::vector<bool> heads(rows, true);
  std::vector<bool> has_text(rows, false);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i].header || places[i].names_row) heads[places[i].row] = false;
    has_text[places[i].row] = has_text[places[i].row] || !grid.cells[i].text.empty();
  }
  std::uint32_t& head_rows = grid.head_rows;
  while (head_rows < rows && heads[head_rows]) ++head_rows;
  if (head_rows == rows) head_rows = rows > 1 ? 1 : 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const TableCell& place = places[i];
    const std::string text = OneLineOf(grid.cells[i].text);
    const bool names_columns = place.first_row < head_rows || (place.header && place.names_column);
    if (names_columns && place.again()) {
      grid.names[i] = true;  // its column is named already
    } else if (names_columns) {
      const auto first = grid.columns.begin() + place.column;
      const auto end = first + std::min(place.columns, columns - place.column);
      grid.names[i] =
          std::all_of(first, end, [&text](const std::string& name) { return HasRoom(name, text); });
      if (!grid.names[i]) continue;
      std::for_each(first, end, [&text](std::string& name) { AppendName(name, text); });
    } else if (place.header && HasRoom(grid.rows[place.row], text)) {
      AppendName(grid.rows[place.row], text);
      grid.names[i] = true;
    }
  }
  return grid;
}

/// A name that no cell with text tells would be lost: then it is a cell itself.
void KeepLoneNames(const std::vector<TableCell>& places, Grid& grid) {
  std::vector<bool> told(grid.rows.size(), false);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!grid.names[i] && !grid.cells[i].text.empty()) told[places[i].row] = true;
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool of_row =
        grid.names[i] && places[i].first_row >= grid.head_rows && !places[i].names_column;
    if (of_row && !told[places[i].row]) {
      grid.names[i] = false;
      grid.rows[places[i].row].clear();
    }
  }
}

Block TableBlock(const Grid& grid, Block caption, std::uint32_t rows, std::uint32_t columns) {
  caption.kind = BlockKind::kTable;
  caption.row = rows;
  caption.column = columns;
  const bool named = std::any_of(grid.columns.begin(), grid.columns.end(),
                                 [](const std::string& name) { return !name.empty(); });
  if (named) {
    for (const std::string& name : grid.columns) {
      if (name.empty()) continue;
      if (!caption.column_name.empty()) caption.column_name += ", ";
      caption.column_name += name;
    }
  }
  return caption;
}

}  // namespace

void TableReader::BeginRow() {
  ++rows_;
  column_ = 0;
}

void TableReader::BeginCell(TableCell cell) {
  if (rows_ == 0) BeginRow();
  const std::uint32_t row = rows_ - 1;
  while (column_ < busy_.size() && busy_[column_] > row) ++column_;
  if (column_ >= kMostColumns) column_ = kMostColumns - 1;
  cell.row = cell.first_row = row;
  cell.column = column_;
  cell.columns = std::clamp<std::uint32_t>(cell.columns, 1, kMostColumns - column_);
  const std::uint32_t end = column_ + cell.columns;
  if (busy_.size() < end) busy_.resize(end, 0);
  for (std::uint32_t c = column_; c < end; ++c) busy_[c] = row + cell.rows;
  columns_ = std::max(columns_, end);
  column_ = end;
  cells_.push_back(cell);
  cell_open_ = true;
}

void TableReader::EndCell(std::size_t end_block) {
  if (cell_open_) cells_.back().end_block = end_block;
  cell_open_ = false;
}

bool TableReader::IsLayout(const Document& document) const {
  if (layout_ || columns_ < 2 || cells_.empty()) return true;
  const bool named =
      caption_end_ > caption_first_ ||
      std::any_of(cells_.begin(), cells_.end(), [](const TableCell& cell) { return cell.header; });
  if (named) return false;
  for (const TableCell& cell : cells_) {
    for (std::size_t i = cell.first_block; i < cell.end_block; ++i) {
      const BlockKind kind = document.blocks[i].kind;
      if (kind == BlockKind::kHeading || kind == BlockKind::kList) return true;
    }
    if (cell.end_block > cell.first_block + 3) return true;
  }
  return false;
}

/// All cells row by row, those that span rows in each of them; a table that would grow too much by
/// that is told without.
std::vector<TableCell> TableReader::ToldCells(const Document& document) const {
  const auto size = [&document](const TableCell& cell) {
    std::size_t bytes = kCellSize;
    for (std::size_t i = cell.first_block; i < cell.end_block; ++i) {
      bytes += document.blocks[i].text.size();
    }
    return bytes;
  };
  std::size_t own = 0, again = 0;
  for (const TableCell& cell : cells_) {
    const std::size_t more = std::min(cell.rows, rows_ - cell.row) - 1;
    if (cell.first_block < cell.end_block) again += more * size(cell);
    own += size(cell);
  }
  if (again == 0 || again > std::max(kMostAgain, 4 * own)) return cells_;
  std::vector<TableCell> told;
  for (TableCell cell : cells_) {
    told.push_back(cell);
    const std::uint32_t end = cell.row + std::min(cell.rows, rows_ - cell.row);
    if (cell.first_block == cell.end_block) continue;
    while (++cell.row < end) told.push_back(cell);
  }
  std::stable_sort(told.begin(), told.end(), [](const TableCell& a, const TableCell& b) {
    return std::pair(a.row, a.column) < std::pair(b.row, b.column);
  });
  return told;
}

std::vector<std::size_t> TableReader::Finish(Document& document) const {
  const std::size_t count = document.blocks.size() - std::min(first_block_, document.blocks.size());
  std::vector<std::size_t> now(count + 1);
  for (std::size_t i = 0; i <= count; ++i) now[i] = first_block_ + i;
  if (IsLayout(document)) return now;

  const std::vector<TableCell> places = ToldCells(document);
  std::vector<Block> cells;
  for (const TableCell& cell : places) {
    cells.push_back(Joined(document.blocks, cell.first_block, cell.end_block));
    if (cell.again()) std::erase_if(cells.back().marks, IsPrintPage);
  }
  Grid grid = NamedGrid(places, std::move(cells), rows_, columns_);
  KeepLoneNames(places, grid);
  std::vector<bool> inside(count, false);
  const auto take = [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) inside[i - first_block_] = true;
  };
  for (const TableCell& cell : cells_) take(cell.first_block, cell.end_block);
  take(caption_first_, caption_end_);

  std::vector<Block> blocks;
  for (std::size_t i = 0; i < count; ++i) {
    if (inside[i]) continue;
    now[i] = first_block_ + blocks.size();
    blocks.push_back(document.blocks[first_block_ + i]);
  }
  const std::size_t table = first_block_ + blocks.size();
  for (std::size_t i = 0; i < count; ++i) now[i] = inside[i] ? table : now[i];
  blocks.push_back(TableBlock(grid, Joined(document.blocks, caption_first_, caption_end_),
                              rows_ - grid.head_rows, columns_));
  for (std::size_t i = 0; i < places.size(); ++i) {
    const TableCell& place = places[i];
    for (std::size_t b = place.first_block; b < place.end_block && !place.again(); ++b) {
      now[b - first_block_] = grid.names[i] ? table : first_block_ + blocks.size();
    }
    Block& cell = grid.cells[i];
    if (grid.names[i] || (cell.text.empty() && cell.marks.empty())) continue;
    cell.row = place.row < grid.head_rows ? 1 : place.row - grid.head_rows + 1;
    cell.column = place.column + 1;
    cell.label = grid.rows[place.row];
    cell.column_name = grid.columns[place.column];
    blocks.push_back(std::move(cell));
  }
  now[count] = first_block_ + blocks.size();
  document.blocks.resize(first_block_);
  std::move(blocks.begin(), blocks.end(), std::back_inserter(document.blocks));
  return now;
}

}  // namespace moontrace
