#pragma once

#include <cstddef>

#include "sim/picture/drawing.h"
#include "textures/fonts/script.h"

namespace moontrace {

/// Signs of a table and in one of its rows.
constexpr std::size_t kMostInTable = 256;
constexpr std::size_t kRowOfTable = 8;

/// A table of a script's signs, at most kMostInTable, in the script's order: each in its true
/// proportions on its base line, its stroke width, its name below, a ring where a stroke starts.
Drawing ScriptTable(const Script& script);

}  // namespace moontrace
