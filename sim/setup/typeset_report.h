#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "sim/trial/metrics_json.h"
#include "textures/fonts/script.h"
#include "textures/relief/groove_links.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

std::size_t CountSigns(const Typeset& set);
/// Line rules on all pages. Throws InputError where there is no room for them or for the raised
/// margin.
std::size_t CountRules(const Typeset& set, const Script& script);
/// Rules, raised margin and texture in words, one line each; none for a plain sheet.
void SaySheet(const Typeset& set, const Script& script,
              const std::function<void(const std::string&)>& say_line);

/// Groove links of all pages, and the places where none keeps the gap.
struct LinkCounts {
  std::size_t links = 0, missing = 0;
};
LinkCounts CountLinks(const Typeset& set, const Script& script);

/// Letters, paper and replacements as JSON, without the pages.
Json TypesetJson(const Typeset& set, const Script& script);

/// Each character that was left out, replaced or is doubtful, the first 20 of each kind, then how
/// many more.
void SayReplacements(const Typeset& set, const std::function<void(const std::string&)>& say_line);

/// On one line; bytes that are not UTF-8 (of a path) are replaced.
std::string Dump(const Json& json);

}  // namespace moontrace
