#pragma once

#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// A text of one page lies in the middle of a square sheet that it fills but for the margins, as
/// long as it is no higher than the sheet that it was set on is wide, margins included; else all
/// stays as it is. Before links are looked for.
void FitSheet(Typeset& set, const Script& script);
/// Likewise in the middle of the sheet that it was set on, which stays.
void CentreText(Typeset& set, const Script& script);

}  // namespace moontrace
