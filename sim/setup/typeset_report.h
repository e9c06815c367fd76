#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "sim/picture/link_messages.h"
#include "sim/trial/metrics_json.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// What lies on pages.
struct PageCounts {
  std::size_t pages = 0, lines = 0, signs = 0;
  std::size_t rules = 0;  ///< line rules
  LinkCounts links;
};

/// Adds what lies on one page. Throws InputError where there is no room for line rules or for the
/// raised margin.
void AddCounts(const TextPage& page, const Script& script, const TypeStyle& style,
               PageCounts& counts);

std::size_t CountSigns(const Typeset& set);
/// Groove links of all pages.
LinkCounts CountLinks(const Typeset& set, const Script& script);

/// Rules, raised margin and texture in words, one line each; none for a plain sheet.
void SaySheet(const TypeStyle& style, std::size_t rules,
              const std::function<void(const std::string&)>& say_line);

/// Letters, paper and replacements as JSON, without the pages.
Json TypesetJson(const Typeset& set, const Script& script);
/// The same of a text whose pages are not in `set`, or not all.
Json TypesetJson(const Typeset& set, const Script& script, const PageCounts& counts);

/// Each character that was left out, replaced or is doubtful, the first `most` of each kind, then
/// how many more. Not those for which whole words are left out (left_out.h).
void SayReplacements(const Typeset& set, const std::function<void(const std::string&)>& say_line,
                     std::size_t most = 20);

/// On one line; bytes that are not UTF-8 (of a path) are replaced.
std::string Dump(const Json& json);

}  // namespace moontrace
