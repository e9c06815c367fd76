#include "sim/page_view/view_look.h"

#include <gtest/gtest.h>

#include "tests/sim/contrast.h"

namespace moontrace {
namespace {

TEST(ViewLayout, PartsFillThePictureWithoutOverlap) {
  const ViewLayout layout = LayoutOf(1280, 720, 330, 280, 60);
  EXPECT_EQ(layout.panel, (PixelBox{0, 0, 330, 720}));
  EXPECT_EQ(layout.page, (PixelBox{330, 60, 670, 660}));
  EXPECT_EQ(layout.plots, (PixelBox{1000, 60, 280, 660}));
  EXPECT_EQ(layout.text, (PixelBox{330, 0, 950, 60}));
}

TEST(ViewLayout, ThePageOutlastsPlotsThenPanelThenText) {
  EXPECT_TRUE(LayoutOf(700, 400, 330, 280, 60).plots.empty());
  EXPECT_FALSE(LayoutOf(700, 400, 330, 280, 60).panel.empty());
  EXPECT_TRUE(LayoutOf(400, 400, 330, 280, 60).panel.empty());
  EXPECT_FALSE(LayoutOf(400, 400, 330, 280, 60).text.empty());
  EXPECT_TRUE(LayoutOf(100, 100, 330, 280, 60).text.empty());
  EXPECT_EQ(LayoutOf(1, 1, 330, 280, 60).page, (PixelBox{0, 0, 1, 1}));
}

TEST(ViewLayout, APixelBelongsToOneBox) {
  const ViewLayout layout = LayoutOf(1280, 720, 330, 280, 60);
  EXPECT_TRUE(layout.panel.Has(329.5, 10));
  EXPECT_FALSE(layout.panel.Has(330, 10));
  EXPECT_TRUE(layout.page.Has(330, 60));
}

// WCAG 2.1 AA; before, a chosen control had 2.5 beside what is round it, and a slider's 1.3.
TEST(ViewColors, TextAndControlsHaveContrast) {
  for (const bool high : {false, true}) {
    ViewLook look;
    look.high_contrast = high;
    const ViewColors colors = ColorsOf(look);
    for (const Color& under : {colors.back, colors.pane, colors.button, colors.chosen}) {
      EXPECT_GE(Contrast(colors.text, under), kContrastOfText) << high;
    }
    EXPECT_GE(Contrast(colors.title, colors.back), kContrastOfText) << high;
    for (const Color& beside : {colors.back, colors.button}) {
      EXPECT_GE(Contrast(colors.edge, beside), kContrastOfGraphics) << high;
      EXPECT_GE(Contrast(colors.focus, beside), kContrastOfGraphics) << high;
    }
    EXPECT_GE(Contrast(colors.chosen, colors.button), kContrastOfGraphics) << high;
    for (const Color& curve : CurveColors(look)) {
      EXPECT_GE(Contrast(curve, colors.pane), kContrastOfGraphics) << high;
    }
  }
}

}  // namespace
}  // namespace moontrace
