#pragma once

#include "sim/view/view_look.h"

struct mjUI_;

namespace moontrace {

/// Spacing and colours of MuJoCo's controls for the tutor's panel: labels of 13 letters and choices
/// of 9, two side by side, have room.
void SetTheme(mjUI_& ui, const ViewColors& colors);

}  // namespace moontrace
