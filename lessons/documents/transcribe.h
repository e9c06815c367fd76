#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lessons/documents/document.h"

namespace moontrace {

/// The words of a link, or of a note's call.
struct TranscribedLink {
  std::size_t begin = 0, end = 0;  ///< of the words, without the mark [bytes]
  std::size_t block = 0;           ///< it stands in that
  std::size_t mark = 0;            ///< of the block's
};

/// Where a page of the printed book begins.
struct TranscribedPage {
  std::size_t begin = 0;  ///< [bytes]
  std::string name;
};

/// A document as one text, with the marks that TakeMarks of `textures/typeset` reads.
struct Transcription {
  std::string text;                 ///< UTF-8
  std::vector<std::size_t> begins;  ///< of each block: where its first line begins [bytes]
  std::vector<TranscribedLink>
      links;  ///< ascending; one that is broken by a line's end several times
  std::vector<TranscribedPage> pages;  ///< ascending
};

/// Writes a document as text: "# " before headings ("###" for all below the third level), "> "
/// before lines of quotations, "[words](address)" for links and calls of notes; lists and tables
/// say how large they are, items have their numbers, each cell is a line "row, column: value";
/// pictures are
/// "(picture: words)". Characters of the text that look like marks get a backslash, as TakeMarks
/// has it. A link whose words have brackets inside is left as its words.
Transcription Transcribe(const Document& document);

}  // namespace moontrace
