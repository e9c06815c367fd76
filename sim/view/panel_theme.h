#pragma once

#include "sim/view/view_look.h"

struct mjUI_;
struct mjrContext_;

namespace moontrace {

/// Spacing and colours of MuJoCo's controls for the tutor's panel: labels of 13 letters and choices
/// of 9, two side by side, have room.
void SetTheme(mjUI_& ui, const ViewColors& colors);

/// Width of what may stand behind an item's label [points].
int TextRoom(const mjrContext_& context);

}  // namespace moontrace
