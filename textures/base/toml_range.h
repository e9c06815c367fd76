#pragma once

#include <string>

#include "textures/base/toml_reader.h"

namespace moontrace {

/// The value that stands at `key`, which must lie from `low` to `high`. Throws InputError
/// (file:line:column, the range) for others, NaN among them.
double InRange(const TomlTable& table, const std::string& key, double value, double low,
               double high);

}  // namespace moontrace
