#include "sim/picture/moon_marks.h"

#include <gtest/gtest.h>

#include "tests/sim/contrast.h"

namespace moontrace {
namespace {

// Before, a groove below a traced line had 1.8 on white, a link between letters 2.4.
TEST(PicturePalette, LinesAreSeenOnPaperAndWaysInTheirGrooves) {
  const Color white{1, 1, 1};
  for (const Color& color : {palette::kInk, palette::kGroove, palette::kRidge, palette::kLink,
                             palette::kTip, palette::kAway, palette::kPaperEdge}) {
    EXPECT_GE(Contrast(color, white), kContrastOfGraphics);
  }
  for (const Color& under : {palette::kGroove, palette::kRidge, palette::kLink, palette::kRough}) {
    EXPECT_GE(Contrast(palette::kTip, under), kContrastOfGraphics);
  }
}

}  // namespace
}  // namespace moontrace
