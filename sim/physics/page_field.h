#pragma once

#include "textures/field/field.h"
#include "textures/script/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// The field of one page as trials and the view build it; `blank`: paper without grooves.
TextureField PageField(const TextPage& page, const Script& script, const TypeStyle& style,
                       bool blank);

}  // namespace moontrace
