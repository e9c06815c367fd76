#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lessons/documents/document.h"

namespace moontrace {

/// A cell of a table as it was found, and the blocks that were written for it.
struct TableCell {
  std::uint32_t row = 0, column = 0;    ///< from 0
  std::uint32_t rows = 1, columns = 1;  ///< that it spans
  bool header = false;
  bool names_row = false;  ///< by `scope`
  bool names_column = false;
  std::size_t first_block = 0, end_block = 0;
  std::uint32_t first_row = 0;  ///< it begins there; less than `row`: it is told again
  bool again() const { return first_row < row; }
};

/// A table while it is read: cells get their places, as rows and columns are spanned.
class TableReader {
 public:
  /// `first_block`: the next one of the document. `presented`: its author says that it is none.
  TableReader(std::size_t first_block, bool presented)
      : first_block_(first_block), layout_(presented) {}

  void BeginRow();
  void BeginCell(TableCell cell);
  void EndCell(std::size_t end_block);
  void BeginCaption(std::size_t block) { caption_first_ = caption_end_ = block; }
  void EndCaption(std::size_t block) { caption_end_ = block; }
  /// Another table stands in it: then it only places things beside each other.
  void SetLayout() { layout_ = true; }

  /// Makes one block of each cell, with the names of its row and column, behind one that tells of
  /// the table. A cell over several rows is told in each. A table that only places things, or has
  /// one column, stays what its cells hold. What stands outside of cells comes before. Gives for
  /// each former block from the first one the index where it is now.
  std::vector<std::size_t> Finish(Document& document) const;
  std::size_t first_block() const { return first_block_; }

 private:
  bool IsLayout(const Document& document) const;
  std::vector<TableCell> ToldCells(const Document& document) const;
  std::size_t first_block_ = 0;
  std::size_t caption_first_ = 0, caption_end_ = 0;
  bool layout_ = false;
  bool cell_open_ = false;
  std::uint32_t rows_ = 0, columns_ = 0, column_ = 0;
  std::vector<std::uint32_t> busy_;  // for each column the rows that are taken, from the first
  std::vector<TableCell> cells_;
};

}  // namespace moontrace
