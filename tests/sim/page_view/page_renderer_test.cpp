#include "sim/page_view/page_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>

#include "sim/page_view/gl_headless.h"
#include "sim/picture/field_shading.h"
#include "tests/sim/contrast.h"
#include "textures/base/error.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/glyph_group.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

constexpr int kWidth = 640, kHeight = 360;
constexpr double kAspect = static_cast<double>(kWidth) / kHeight;

class PageRendererTest : public testing::Test {
 protected:
  void SetUp() override {
    try {
      gl_ = std::make_unique<HeadlessGl>();
    } catch (const LackError& lack) {
      GTEST_SKIP() << lack.what();
    }
    const Script moon = FindScript("moon");
    set_ = SetText("moon", moon, DefaultStyle(0.012, Relief::kEngraved, moon),
                   {"custom", 0.08, 0.03, 0.005});
    field_ = std::make_unique<TextureField>(BuildTexture(set_.pages.at(0), moon, set_.style));
    renderer_ = std::make_unique<PageRenderer>(kWidth, kHeight);
  }

  Raster Shade(const PageCamera& camera) {
    const Box seen = VisibleBox(camera, kAspect);
    Raster shaded =
        ShadeField(*field_, seen, set_.pages[0].sheet_P, kWidth, kHeight, PageShade{}, 1);
    renderer_->SetSurface(shaded, seen);
    return shaded;
  }

  std::unique_ptr<HeadlessGl> gl_;
  Typeset set_;
  std::unique_ptr<TextureField> field_;
  std::unique_ptr<PageRenderer> renderer_;  // freed before its context
};

// From straight above each point of the picture is one point of the surface: shown as it was
// shaded.
TEST_F(PageRendererTest, ShowsTheShadedFieldPointByPoint) {
  const PageCamera camera = CameraOn(set_.pages[0].sheet_P, kAspect);
  const Raster shaded = Shade(camera);
  const Raster drawn = renderer_->DrawToPicture(camera, {});
  ASSERT_EQ(drawn.rgb.size(), shaded.rgb.size());
  int greatest = 0;
  for (std::size_t i = 0; i < drawn.rgb.size(); ++i) {
    greatest = std::max(greatest, std::abs(int{drawn.rgb[i]} - int{shaded.rgb[i]}));
  }
  EXPECT_LE(greatest, 2);  // a texture's edge falls between two points by rounding
}

/// The middle of the points that are much nearer to a colour than to paper, as shares of the
/// picture.
glm::dvec2 MiddleOf(const Raster& raster, const Color& color) {
  glm::dvec2 sum(0);
  double count = 0;
  for (std::size_t i = 0; i < raster.width * raster.height; ++i) {
    const double red = raster.rgb[3 * i] / 255.0, green = raster.rgb[3 * i + 1] / 255.0,
                 blue = raster.rgb[3 * i + 2] / 255.0;
    const glm::dvec3 off(red - color.red, green - color.green, blue - color.blue);
    if (glm::length(off) > 0.12) continue;
    sum += glm::dvec2(static_cast<double>(i % raster.width) + 0.5,
                      static_cast<double>(raster.height - 1 - i / raster.width) + 0.5);
    ++count;
  }
  return sum / std::max(count, 1.0) / glm::dvec2(raster.width, raster.height);
}

TEST_F(PageRendererTest, MarksLieWhereTheirPointsOfThePageAre) {
  const PageCamera camera = CameraOn(set_.pages[0].sheet_P, kAspect, 0.4);
  Shade(camera);
  for (const glm::dvec2 share : {glm::dvec2(0.25, 0.6), glm::dvec2(0.7, 0.3)}) {
    ViewMarks marks;
    marks.bead_P = PointUnder(camera, kAspect, share);
    const glm::dvec2 seen =
        MiddleOf(renderer_->DrawToPicture(camera, marks), view_color::kGuidance);
    // half of the ball is below the paper when seen aslant: within its radius of 0.9 %
    EXPECT_NEAR(seen.x, share.x, 0.005);
    EXPECT_NEAR(seen.y, share.y, 0.012);
  }
}

// Before, the push had 2.0 and the letter that is meant 2.8.
TEST(ViewColor, MarksAreSeenOnThePaper) {
  for (const PageShade& shade : {PageShade{}, HighContrastShade()}) {
    for (const Color& relief : {shade.groove, shade.ridge}) {
      EXPECT_GE(Contrast(relief, shade.paper), kContrastOfGraphics);
    }
    for (const Color& mark : {view_color::kForce, view_color::kGuidance, view_color::kLetter}) {
      EXPECT_GE(Contrast(mark, shade.paper), kContrastOfGraphics);
    }
    for (int i = 0; i <= 10; ++i) {  // the tip's way, from on the stroke to beside it
      const Color &on = view_color::kOnStroke, &off = view_color::kOffStroke;
      const double t = i / 10.0;
      const Color between{on.red + t * (off.red - on.red), on.green + t * (off.green - on.green),
                          on.blue + t * (off.blue - on.blue)};
      EXPECT_GE(Contrast(between, shade.paper), kContrastOfGraphics) << i;
    }
    EXPECT_GE(Contrast(view_color::kPrint, shade.paper), kContrastOfText);
  }
}

TEST_F(PageRendererTest, WithoutMarksNothingIsOverThePage) {
  const PageCamera camera = CameraOn(set_.pages[0].sheet_P, kAspect);
  Shade(camera);
  const Raster plain = renderer_->DrawToPicture(camera, {});
  ViewMarks marks;
  marks.tip_P = glm::dvec3(0.04, 0.015, 0);
  marks.force_P = {0, 0.5, 0.5};
  marks.print.push_back({{0.02, 0.01}, "m"});
  EXPECT_NE(renderer_->DrawToPicture(camera, marks).rgb, plain.rgb);
  EXPECT_EQ(renderer_->DrawToPicture(camera, {}).rgb, plain.rgb);
}

}  // namespace
}  // namespace moontrace
