#pragma once

#include <string>

#include "lessons/documents/document.h"
#include "lessons/documents/zip_archive.h"

namespace moontrace {

/// Reads a book, EPUB 2 or 3: its chapters in the order of the spine, those outside of the reading
/// order behind them; the contents of EPUB 3, else those of EPUB 2; printed pages. A chapter is
/// read as XML, and as a web page is where it is not well-formed. What is missing or unreadable is
/// noted in Document::left_out. Throws InputError (`name`, cause): no book, encrypted, nothing to
/// read.
Document ReadEpub(ZipArchive& zip, const std::string& name);

}  // namespace moontrace
