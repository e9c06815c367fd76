#include "sim/session/turn_mark.h"

#include <algorithm>

#include "sim/tutor/page_messages.h"
#include "textures/base/error.h"

namespace moontrace {

PaperPatch TurnMark(const PageSpec& page) {
  constexpr double kLeastMargin = 0.004;  // [m], two waves
  constexpr double kGreatest = 0.015;     // [m], as high as a fingertip is wide
  constexpr double kGap = 0.2;            // of its height, to the text
  if (page.margin < kLeastMargin) throw InputError(say::NoRoomForTurnMark(kLeastMargin));
  const double height = std::min(page.margin, kGreatest);
  const double width = std::min(3 * height, page.width);
  PaperPatch mark;
  mark.box_P = {{page.width - width, page.margin - height},
                {page.width, page.margin - kGap * height}};
  mark.texture.kind = PaperKind::kGrid;
  mark.texture.amplitude = 50e-6;
  mark.texture.wavelength = 2e-3;
  mark.fade = height / 8;
  return mark;
}

}  // namespace moontrace
