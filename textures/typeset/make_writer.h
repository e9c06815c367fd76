#pragma once

#include <memory>

#include "textures/fonts/script.h"
#include "textures/typeset/writer.h"

namespace moontrace {

/// The writer that a script asks for. Keeps a reference to it. Throws InputError: an unknown grade,
/// table or form of h, older punctuation where the script has none, LackError: a Braille script
/// without liblouis.
std::unique_ptr<Writer> MakeWriter(const Script& script, const TypeStyle& style);

}  // namespace moontrace
