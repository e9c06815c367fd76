#pragma once

#include <string>

#include "lessons/documents/document.h"

namespace moontrace {

/// The table of liblouis by which Braille of a language is read: of its tag, such as "de-AT".
/// English (UEB, contracted) where none is known.
std::string BrailleTableFor(const std::string& language);

/// Writes the Braille patterns of a document as print, as a table of liblouis reads them; what it
/// does not read stays as it is. Marks stay on their words. Throws as BrailleTable: LackError
/// without liblouis, InputError for a table that is none.
void ReadPatterns(Document& document, const std::string& table);

}  // namespace moontrace
