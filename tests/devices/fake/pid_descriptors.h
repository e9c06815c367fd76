#pragma once

#include <cstdint>
#include <vector>

namespace moontrace::fake {

/// Report descriptor with the reports of OpenFFBoard with two axes, byte for byte of the same
/// layout (facts of its descriptor; our own writing).
std::vector<std::uint8_t> OpenFfBoardDescriptor();

/// With the report numbers and value ranges of VPforce Rhino, as far as they are known.
std::vector<std::uint8_t> RhinoDescriptor();

}  // namespace moontrace::fake
