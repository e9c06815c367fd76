#pragma once

#include <string>
#include <string_view>

#include "textures/field/sampled.h"

namespace moontrace {

/// A grey picture (PGM, plain P2 or binary P5, 8 or 16 bits) as heights: black -1, white 1, the
/// picture's top at the array's top. `name` stands in messages. Throws InputError: another format,
/// cut off, a side below 2 or above 4096, a value above the picture's greatest.
SampledHeights ParsePgm(std::string_view bytes, const std::string& name);

/// The same from a file of at most 100 MB.
SampledHeights ReadPgm(const std::string& path);

}  // namespace moontrace
