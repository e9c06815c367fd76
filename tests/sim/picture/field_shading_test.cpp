#include "sim/picture/field_shading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "textures/field/profile.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/glyph_group.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

constexpr double kWidth = 0.0014, kDepth = 0.0007, kRounding = 0.00028;  // 12 mm letters [m]

/// One groove along y, through x = 0.
Texture Groove(Relief relief) {
  Element element;
  element.shape = Line{{0, -0.02}, {0, 0.02}};
  element.profile = {kWidth, kDepth, kRounding};
  Group group;
  group.elements.push_back(element);
  Texture texture;
  texture.layers.push_back({Finish(group), relief});
  return texture;
}

struct Shown {
  Raster raster;
  Box view_P;
  double BrightnessAt(double x, const Color& tint) const {
    const double share = (x - view_P.min.x) / (view_P.max.x - view_P.min.x);
    const auto column = static_cast<std::size_t>(share * static_cast<double>(raster.width));
    return raster.rgb[3 * (raster.width * (raster.height / 2) + column)] / (255 * tint.red);
  }
};

/// Tinted white throughout, so that only the light tells.
PageShade White() {
  PageShade shade;
  shade.paper = shade.groove = shade.ridge = {0.5, 0.5, 0.5};
  return shade;
}

Shown Show(const TextureField& field, double half, std::size_t width) {
  const Box view{{-half, -half / 10}, {half, half / 10}};
  return {ShadeField(field, view, view, width, width / 10, White()), view};
}

// Zoomed to one groove: the middles of its flanks have slope s = D / (w/2 - r) (design section 4),
// normal (+-s, 0, 1) / sqrt(1 + s^2); light from the left at (-0.48, 0.64, 0.60). The left flank
// falls away from the light, the right one faces it.
TEST(FieldShading, FlanksHaveTheBrightnessOfTheirGradient) {
  const TextureField field(Groove(Relief::kEngraved));
  const Shown shown = Show(field, kWidth, 2000);
  const PageShade shade = White();
  const double s = kDepth / (kWidth / 2 - kRounding);
  const auto lit = [&](double slope) {
    const double dot = (-0.48 * -slope + 0.60) / std::sqrt(1 + slope * slope) / 0.60;
    return shade.ambient + (1 - shade.ambient) * std::max(dot, 0.0);
  };
  const double x = kWidth / 4;  // within r .. w/2 - r
  // half a step of 256 over a grey of 0.5
  const double step = 0.5 / 127;
  EXPECT_NEAR(shown.BrightnessAt(-x, shade.paper), lit(-s), step);
  EXPECT_NEAR(shown.BrightnessAt(x, shade.paper), lit(s), step);
  EXPECT_NEAR(shown.BrightnessAt(0, shade.paper), 1, 2 * step);  // the floor is level
  EXPECT_NEAR(shown.BrightnessAt(0.9 * kWidth, shade.paper), 1, step);
  EXPECT_LT(lit(-s), 0.75);
  EXPECT_GT(lit(s), 1.04);
}

TEST(FieldShading, RidgesAreLitFromTheOtherSide) {
  const TextureField grooves(Groove(Relief::kEngraved)), ridges(Groove(Relief::kEmbossed));
  const Shown engraved = Show(grooves, kWidth, 2000), embossed = Show(ridges, kWidth, 2000);
  const Color grey = White().paper;
  const double x = kWidth / 4, step = 1.0 / 127;
  EXPECT_NEAR(engraved.BrightnessAt(x, grey), embossed.BrightnessAt(-x, grey), step);
  EXPECT_NEAR(engraved.BrightnessAt(-x, grey), embossed.BrightnessAt(x, grey), step);
}

TEST(FieldShading, DepthIsTintedAndTheDeskIsNotPaper) {
  const TextureField field(Groove(Relief::kEngraved));
  const Box view{{-0.01, -0.001}, {0.01, 0.001}}, sheet{{-0.005, -1}, {0.005, 1}};
  const PageShade shade;
  const Raster raster = ShadeField(field, view, sheet, 200, 20, shade);
  const auto red = [&](std::size_t column) { return raster.rgb[3 * (200 * 10 + column)]; };
  EXPECT_EQ(red(70), std::lround(255 * shade.paper.red));
  EXPECT_EQ(red(10), std::lround(255 * shade.desk.red));
  // 0.05 mm from the middle the groove is level to 1 % and at its full depth but for r/2 of slope
  EXPECT_LT(red(100), std::lround(255 * (shade.groove.red + 0.2)));
}

// A line is read where it is darkest: across it, lit from the side, the darkest points lie round
// its middle, by a tenth of its width at most (its floor reaches twice as far each way).
TEST(FieldShading, AGrooveIsDarkestAlongItsMiddle) {
  const TextureField field(Groove(Relief::kEngraved));
  const Box view{{-kWidth, -kWidth / 10}, {kWidth, kWidth / 10}};
  constexpr std::size_t kColumns = 400, kRows = 40;
  const Raster raster = ShadeField(field, view, view, kColumns, kRows, PageShade{});
  const auto red = [&](std::size_t i) { return int{raster.rgb[3 * (kColumns * kRows / 2 + i)]}; };
  int darkest = 255;
  for (std::size_t i = 0; i < kColumns; ++i) darkest = std::min(darkest, red(i));
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < kColumns; ++i) {
    if (red(i) > darkest + 8) continue;
    sum += 2 * kWidth * (static_cast<double>(i) + 0.5) / kColumns - kWidth;
    ++count;
  }
  EXPECT_NEAR(sum / count, 0, 0.1 * kWidth);
}

TEST(FieldShading, ThreadsChangeNothing) {
  const Script moon = FindScript("moon");
  const Typeset set = SetText("moon", moon, DefaultStyle(0.012, Relief::kEngraved, moon),
                              {"custom", 0.08, 0.03, 0.005});
  const TextureField field(BuildTexture(set.pages.at(0), moon, set.style));
  const Box sheet = set.pages[0].sheet_P;
  const Raster one = ShadeField(field, sheet, sheet, 301, 113, PageShade{}, 1);
  const Raster three = ShadeField(field, sheet, sheet, 301, 113, PageShade{}, 3);
  EXPECT_EQ(one.rgb, three.rgb);
}

}  // namespace
}  // namespace moontrace
