#pragma once

#include <string>

#include "lessons/documents/document.h"

namespace moontrace {

/// How a document is opened.
struct OpenOptions {
  DocumentLimits limits;
  bool marks = false;  ///< see ReadPlainText
};

/// Reads a file of plain text, HTML or EPUB, told apart by what it holds. Time and memory are
/// bounded by the limits. Throws InputError (path, cause, cure): missing, a pipe or a device, too
/// large, no text, encrypted, of another kind, nothing to read. LackError: the program was built
/// without the library that this kind needs.
Document OpenDocument(const std::string& path, const OpenOptions& options);

/// The same of bytes; `name` stands in messages, its ending tells nothing.
Document ReadDocument(std::string bytes, const std::string& name, const OpenOptions& options);

}  // namespace moontrace
