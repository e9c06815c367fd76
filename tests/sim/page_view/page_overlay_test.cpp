#include "sim/page_view/page_overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <vector>

#include "sim/page_view/gl_headless.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

constexpr int kWidth = 640, kHeight = 360;
constexpr double kAspect = static_cast<double>(kWidth) / kHeight;

class PageOverlayTest : public testing::Test {
 protected:
  void SetUp() override {
    try {
      gl_ = std::make_unique<HeadlessGl>();
      canvas_ = std::make_unique<Canvas>(16);
    } catch (const LackError& lack) {
      GTEST_SKIP() << lack.what();
    }
    renderer_ = std::make_unique<PageRenderer>(kWidth, kHeight);
    renderer_->SetDesk({1, 1, 1});
  }

  /// On white.
  Raster Drawn(const ViewMarks& marks) {
    renderer_->Aim(false);
    renderer_->Draw(camera_, {}, 0, 0, kWidth, kHeight);
    canvas_->Begin(kWidth, kHeight, {});
    DrawPageOverlay(marks, camera_, {0, 0, kWidth, kHeight}, *canvas_);
    canvas_->End(true);
    return renderer_->Picture();
  }
  static Color At(const Raster& raster, glm::dvec2 share) {
    const auto x = static_cast<std::size_t>(share.x * kWidth);
    const auto y = static_cast<std::size_t>((1 - share.y) * kHeight);
    const std::size_t at = 3 * (y * raster.width + x);
    return {raster.rgb.at(at) / 255.0, raster.rgb.at(at + 1) / 255.0,
            raster.rgb.at(at + 2) / 255.0};
  }
  static double Off(const Color& a, const Color& b) {
    return std::max(
        {std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
  }
  glm::dvec2 ShareAt(glm::dvec3 p_P) const {
    return ShareOf(camera_, kAspect, p_P).value_or(glm::dvec2(-1));
  }

  std::unique_ptr<HeadlessGl> gl_;
  std::unique_ptr<Canvas> canvas_;  // freed before its context
  std::unique_ptr<PageRenderer> renderer_;
  PageCamera camera_{{0, 0}, 0.1, 0.3};
};

TEST_F(PageOverlayTest, TheWayHasTheColourOfItsErrorWhereItWent) {
  ViewMarks marks;
  marks.path = {{{-0.04, 0.01, 0}, 0, true}, {{0, 0.01, 0}, 0, false}, {{0.04, 0.01, 0}, 1, false}};
  const Raster raster = Drawn(marks);
  EXPECT_LT(Off(At(raster, ShareAt({-0.02, 0.01, 0})), view_color::kOnStroke), 0.03);
  EXPECT_LT(Off(At(raster, ShareAt({0.02, 0.01, 0})), view_color::kOffStroke), 0.03);
  EXPECT_LT(Off(At(raster, ShareAt({-0.02, 0.03, 0})), {1, 1, 1}), 0.03);
  marks.path[2].begins = true;  // the tip was lifted
  EXPECT_LT(Off(At(Drawn(marks), ShareAt({0.02, 0.01, 0})), {1, 1, 1}), 0.03);
}

// The pen's point is dark, its shadow paler, apart from it by the height.
TEST_F(PageOverlayTest, ThePenPointsAtTheTipAndItsShadowPartsAsItIsLifted) {
  std::vector<double> shadows;
  for (const double height : {0.0, 0.003, 0.006}) {
    ViewMarks marks;
    marks.tip_P = glm::dvec3(-0.02, 0.02, height);
    const Raster raster = Drawn(marks);
    // half a unit along the pen, a unit being a hundredth of the picture
    const glm::dvec2 inside = ShareAt(*marks.tip_P) + 0.008 * glm::dvec2(0.60 / kAspect, -0.80);
    EXPECT_LT(At(raster, inside).red, 0.45) << height;
    double shadow = 0;
    for (std::size_t i = 0; i < raster.rgb.size(); i += 3) {
      const int red = raster.rgb[i];
      if (std::abs(red - 214) <= 3 && red == raster.rgb[i + 2]) ++shadow;  // 0.16 of black on white
    }
    shadows.push_back(shadow);
  }
  EXPECT_GT(shadows[1], 1.5 * shadows[0]);  // where the pen does not cover it
  EXPECT_GE(shadows[2], shadows[1]);
}

TEST_F(PageOverlayTest, PrintIsOfAnyAlphabetAndStaysInsideItsPart) {
  ViewMarks marks;
  const Raster empty = Drawn(marks);
  marks.print.push_back({{0, 0}, "\xc3\xa9\xd0\xb6", true});  // Latin with an accent, Cyrillic
  EXPECT_NE(Drawn(marks).rgb, empty.rgb);
  marks.print.front().at_P = {1, 1};
  EXPECT_EQ(Drawn(marks).rgb, empty.rgb);
}

}  // namespace
}  // namespace moontrace
