#pragma once

#include <vector>

#include "textures/field/field.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// The field of one page, for trials and for the hand in real time; `blank`: paper without grooves.
/// With marks of rough paper beside its text.
TextureField PageField(const TextPage& page, const Script& script, const TypeStyle& style,
                       bool blank, const std::vector<PaperPatch>& marks = {});

}  // namespace moontrace
