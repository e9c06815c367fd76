#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "sim/app/metrics_json.h"
#include "textures/script.h"
#include "textures/typeset.h"

namespace moontrace {

std::size_t CountSigns(const Typeset& set);

/// Letters, paper and replacements as JSON, without the pages.
Json TypesetJson(const Typeset& set, const Script& script);

/// Each character that was left out, replaced or is doubtful, the first 20 of each kind, then how
/// many more.
void SayReplacements(const Typeset& set, const std::function<void(const std::string&)>& say_line);

/// On one line; bytes that are not UTF-8 (of a path) are replaced.
std::string Dump(const Json& json);

}  // namespace moontrace
