#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "textures/field/texture.h"
#include "textures/typeset/fold.h"

namespace moontrace {

/// What a line of the text is; kHead is the running head with the page's number, of no text.
enum class LineKind : std::uint8_t { kPlain, kHeading, kQuotation, kHead };

/// How marks of structure in the text are taken, and how headings are set.
struct StructureStyle {
  bool read = false;  ///< else marks are characters like others
  double heading_scale =
      1.5;  ///< size of headings over that of the text; all lengths in proportion
  std::optional<Relief> heading_relief;  ///< none: the text's
  bool texture = false;                  ///< rough paper below headings, quotations and links
  bool operator==(const StructureStyle&) const = default;
};

/// What was found in a text.
struct StructureCounts {
  std::size_t headings = 0;
  std::size_t quotations = 0;  ///< runs of quoted lines
  std::size_t links = 0;
};

/// Bytes of the text.
struct ByteRange {
  std::uint32_t begin = 0, end = 0;
  bool operator==(const ByteRange&) const = default;
};

/// The structure of one line.
struct LineMarks {
  LineKind kind = LineKind::kPlain;
  std::vector<ByteRange> links;  ///< the words of each, ascending
};

/// Reads the marks of one line and takes them out of it, so that they are not written; what stays
/// keeps its bytes. "# ", "## " or "### " begin a heading, which needs a sign behind it; "> " (or
/// ">" alone) a line of a quotation; "[words](address)" is a link: words are anything but brackets
/// and not blank, parentheses in the address are in pairs. What is not whole stays as it is. Time
/// linear in the line. A backslash before "[", or before "#" or ">" at the line's beginning, makes
/// that a character like others and goes (of several there the first). Of a later part of a line
/// (Folder::begins_line) only links are read.
LineMarks TakeMarks(std::string_view text, std::vector<FoldedChar>& line, bool begins_line = true);

}  // namespace moontrace
