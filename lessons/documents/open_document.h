#pragma once

#include <string>

#include "lessons/documents/document.h"

namespace moontrace {

/// How a document is opened.
struct OpenOptions {
  DocumentLimits limits;
  bool marks = false;  ///< see ReadPlainText
};

/// Reads a file of plain text, HTML, EPUB or eBraille, told apart by what it holds, or a Braille
/// file, told by its ending ".brf" or ".brl". Time and memory are bounded by the limits. Throws
/// InputError (path, cause, cure): missing, a pipe or a device, too large, no text, encrypted, of
/// another kind, nothing to read. LackError: the program was built without the library that this
/// kind needs.
Document OpenDocument(const std::string& path, const OpenOptions& options);

/// The same of bytes; `name` stands in messages.
Document ReadDocument(std::string bytes, const std::string& name, const OpenOptions& options);

}  // namespace moontrace
