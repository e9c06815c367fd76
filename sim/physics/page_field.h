#pragma once

#include "textures/field/field.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// The field of one page, for trials and for the hand in real time; `blank`: paper without grooves.
TextureField PageField(const TextPage& page, const Script& script, const TypeStyle& style,
                       bool blank);

}  // namespace moontrace
