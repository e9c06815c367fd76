#pragma once

#include <vector>

#include "sim/reader/line_belief.h"

namespace moontrace {

/// Tells the ink of links from that of letters, as far as depth does: HatchPoint::of_link is set
/// where nothing was felt near by that is surely deeper than a link of `link_depth`, share of the
/// letters'. A link's ends are as deep as letters, and count as theirs. `width`: of a letter's
/// groove [m]. To be asked again when more was felt.
void MarkLinks(std::vector<HatchPoint>& points, double width, double link_depth);

}  // namespace moontrace
