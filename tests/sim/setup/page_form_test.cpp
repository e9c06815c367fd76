#include "sim/setup/page_form.h"

#include <gtest/gtest.h>

#include "sim/setup/options.h"

namespace moontrace {
namespace {

/// The style of Moon letters of 20 mm after a form was applied to what was given.
TypeStyle Formed(const PageForm& form, StyleOptions letters = {}, LayoutOptions layout = {}) {
  letters.size = 0.02;
  Script script = ScriptOf(letters, nullptr);
  ApplyForm(form, script, nullptr, letters, layout);
  return StyleOf(letters, layout, script, nullptr);
}

// The design's defaults at 20 mm: w = 0.1165 em, D = w/2, r = 0.2 w, line pitch 1.8 em.
constexpr double kWidth = 0.1165 * 0.02, kDepth = kWidth / 2, kPitch = 1.8 * 0.02;
constexpr double kRounding = 1e-12;  // of sums and products [m]

TEST(PageForm, LeavesThePageAsItIsByDefault) {
  const TypeStyle style = Formed({});
  EXPECT_NEAR(style.width, kWidth, kRounding);
  EXPECT_NEAR(style.depth, kDepth, kRounding);
  EXPECT_NEAR(style.rounding, 0.2 * kWidth, kRounding);
  EXPECT_NEAR(style.line_pitch, kPitch, kRounding);
  EXPECT_EQ(style.relief, Relief::kEngraved);
  EXPECT_FALSE(style.texture.paper);
}

TEST(PageForm, MakesGroovesDeeperAndWider) {
  PageForm form;
  form.depth = 0.5;
  form.width = 1.2;
  const TypeStyle style = Formed(form);
  EXPECT_NEAR(style.width, 1.2 * kWidth, kRounding);
  EXPECT_NEAR(style.rounding, 1.2 * 0.2 * kWidth, kRounding);
  EXPECT_NEAR(style.depth, 0.5 * 1.2 * kDepth, kRounding);
}

TEST(PageForm, SetsLettersAndLinesApart) {
  PageForm form;
  form.spacing = 1.5;
  form.pitch = 2;
  const TypeStyle style = Formed(form);
  EXPECT_NEAR(style.line_pitch, 1.5 * 2 * kPitch, kRounding);
  EXPECT_NEAR(style.letter_gap, 0.5 * 0.5 * 0.02, kRounding);  // half more of half an em
}

TEST(PageForm, RaisesLettersWithTheDepthAndBlendOfRidges) {
  PageForm form;
  form.relief = Relief::kEmbossed;
  const TypeStyle style = Formed(form);
  EXPECT_EQ(style.relief, Relief::kEmbossed);
  EXPECT_NEAR(style.depth, kWidth / 4, kRounding);
  EXPECT_GT(style.blend_radius, 0);
  form.relief = Relief::kEngraved;
  StyleOptions embossed;
  embossed.embossed = true;
  EXPECT_EQ(Formed(form, embossed).relief, Relief::kEngraved);
  EXPECT_EQ(Formed({}, embossed).relief, Relief::kEmbossed);
}

TEST(PageForm, MultipliesWhatWasGiven) {
  StyleOptions given;
  given.depth = 0.0006;
  PageForm form;
  form.depth = 0.5;
  EXPECT_NEAR(Formed(form, given).depth, 0.0003, kRounding);
}

TEST(PageForm, ChoosesThePaper) {
  PageForm form;
  form.paper = PaperKind::kSine;
  ASSERT_TRUE(Formed(form).texture.paper);
  EXPECT_EQ(Formed(form).texture.paper->kind, PaperKind::kSine);

  LayoutOptions given;
  given.sheet.texture = "noise";
  given.sheet.amplitude = 0.00002;
  given.sheet.wavelength = 0.003;
  EXPECT_FALSE(Formed({}, {}, given).texture.paper) << "smooth was wanted";
  EXPECT_EQ(Formed(form, {}, given).texture.paper->amplitude, 0.00002);
  form.paper = PaperKind::kNoise;
  EXPECT_EQ(Formed(form, {}, given).texture.paper->wavelength, 0.003);
}

TEST(PageForm, ChoosesTheFormOfH) {
  PageForm form;
  form.h_form = "pocket";
  EXPECT_EQ(Formed(form).h_form, "pocket");
  StyleOptions given;
  given.h_form = "arc";
  EXPECT_EQ(Formed({}, given).h_form, "arc");
}

}  // namespace
}  // namespace moontrace
