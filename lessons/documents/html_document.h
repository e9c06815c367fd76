#pragma once

#include <string>

#include "lessons/documents/document.h"

namespace moontrace {

/// HTML, UTF-8, as browsers read it; XHTML that says so (`<?xml`) as XML where it is well-formed.
/// Throws LackError without libgumbo, InputError: too many elements or paragraphs.
Document ReadHtml(const std::string& html, const std::string& name);

}  // namespace moontrace
