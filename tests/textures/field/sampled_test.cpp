#include "textures/field/sampled.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "textures/base/error.h"
#include "textures/field/pgm.h"

namespace moontrace {
namespace {

SampledHeights Random(std::size_t columns, std::size_t rows) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> height(-1, 1);
  std::vector<float> heights;
  for (std::size_t i = 0; i < columns * rows; ++i) {
    heights.push_back(static_cast<float>(height(random)));
  }
  return SampledHeights(columns, rows, heights);
}

TEST(SampledHeight, IsTheSampleAtASample) {
  const SampledHeights heights = Random(9, 7);
  for (std::size_t j = 0; j < 7; ++j) {
    for (std::size_t i = 0; i < 9; ++i) {
      const double u = static_cast<double>(i), v = static_cast<double>(j);
      EXPECT_NEAR(heights.Stretched(u, v).height, heights.heights()[j * 9 + i], 1e-15);
      EXPECT_NEAR(heights.Tiled(u + 9, v + 14).height, heights.heights()[j * 9 + i], 1e-13);
    }
  }
}

// Catmull-Rom gives polynomials of second degree back exactly, away from the edge.
TEST(SampledHeight, FollowsAParaboloidExactly) {
  const auto h = [](double u, double v) {
    return 0.01 * u * u - 0.02 * u * v + 0.005 * v * v - 0.2;
  };
  std::vector<float> heights;
  for (int v = 0; v < 8; ++v) {
    for (int u = 0; u < 8; ++u) heights.push_back(static_cast<float>(h(u, v)));
  }
  const SampledHeights sampled(8, 8, heights);
  for (double u = 1; u <= 6; u += 0.37) {
    for (double v = 1; v <= 6; v += 0.41) {
      const HeightSample sample = sampled.Stretched(u, v);
      EXPECT_NEAR(sample.height, h(u, v), 1e-6);  // samples are floats
      EXPECT_NEAR(sample.gradient.x, 0.02 * u - 0.02 * v, 1e-6);
      EXPECT_NEAR(sample.gradient.y, -0.02 * u + 0.01 * v, 1e-6);
    }
  }
}

// Second derivatives by differences of the gradient: a straddled sample mixes two of them.
TEST(SampledBounds, HoldEverywhere) {
  const SampledHeights heights = Random(12, 10);
  for (const bool tiled : {false, true}) {
    const SampledHeights::Bounds most = heights.GreatestOf(tiled);
    const auto at = [&](double u, double v) {
      return tiled ? heights.Tiled(u, v) : heights.Stretched(u, v);
    };
    std::mt19937_64 random(12);
    std::uniform_real_distribution<double> place(0, 1);
    double u_slope = 0, uu = 0, uv = 0;
    for (int i = 0; i < 100000; ++i) {
      const double u = (tiled ? 24 : 10.99) * place(random),
                   v = (tiled ? 20 : 8.99) * place(random);
      const HeightSample here = at(u, v), right = at(u + 1e-6, v), above = at(u, v + 1e-6);
      ASSERT_LE(std::abs(here.height), most.height);
      ASSERT_LE(std::abs(here.gradient.x), most.slope.x);
      ASSERT_LE(std::abs(here.gradient.y), most.slope.y);
      u_slope = std::max(u_slope, std::abs(here.gradient.x));
      uu = std::max(uu, 1e6 * std::abs(right.gradient.x - here.gradient.x));
      uv = std::max(uv, 1e6 * std::abs(above.gradient.x - here.gradient.x));
      ASSERT_LE(1e6 * std::abs(above.gradient.y - here.gradient.y), most.vv * (1 + 1e-6));
    }
    EXPECT_LE(uu, most.uu * (1 + 1e-6));
    EXPECT_LE(uv, most.uv * (1 + 1e-6));
    EXPECT_GT(u_slope, 0.4 * most.slope.x);
    EXPECT_GT(uu, 0.4 * most.uu);
  }
}

TEST(SampledArray, ThatCannotBeIsRefused) {
  EXPECT_THROW(SampledHeights(1, 4, std::vector<float>(4)), InputError);
  EXPECT_THROW(SampledHeights(4097, 2, std::vector<float>(8194)), InputError);
  EXPECT_THROW(SampledHeights(2, 2, std::vector<float>(3)), InputError);
  EXPECT_THROW(SampledHeights(2, 2, std::vector<float>{0, 0, 0, std::nanf("")}), InputError);
}

std::string ErrorOf(const std::string& bytes) {
  try {
    ParsePgm(bytes, "a.pgm");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// The same picture in each form of the format (netpbm's pgm(5)): black, grey, white above; white,
// black, black below.
TEST(Pgm, FormsAreTheSamePicture) {
  const std::string pixels("\x00\x80\xff\xff\x00\x00", 6);
  const SampledHeights binary = ParsePgm("P5\n# made by hand\n3 2\n255\n" + pixels, "a.pgm");
  const SampledHeights plain = ParsePgm("P2 3 2 255 0 128 255\n255 0 0\n", "a.pgm");
  const std::string wide("\x00\x00\x80\x80\xff\xff\xff\xff\x00\x00\x00\x00", 12);
  const SampledHeights sixteen = ParsePgm("P5 3 2 65535\n" + wide, "a.pgm");
  EXPECT_EQ(binary.columns(), 3U);
  EXPECT_EQ(binary.rows(), 2U);
  // the lower row first
  const std::vector<float> expected{1, -1, -1, -1, 2 * 128.0F / 255 - 1, 1};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(binary.heights()[i], expected[i], 1e-6);
    EXPECT_NEAR(plain.heights()[i], expected[i], 1e-6);
    EXPECT_NEAR(sixteen.heights()[i], expected[i], 1e-6);  // 0x8080 / 0xffff = 0x80 / 0xff
  }
}

TEST(Pgm, BrokenFilesGiveOneLineWithThePlace) {
  EXPECT_EQ(ErrorOf("GIF89a"), "a.pgm: not a PGM picture: give one that begins with P2 or P5");
  EXPECT_EQ(ErrorOf("P2\n3 2\n255\n0 0 0 0 0"),
            "a.pgm:4: the picture ends before its height value: save it again");
  EXPECT_EQ(ErrorOf("P2\n3 2\n255\n0 0 0 0 0 256"),
            "a.pgm:4: height value above 255: raise the greatest value before the heights");
  EXPECT_EQ(ErrorOf("P2\n3 x"), "a.pgm:2: height is not a whole number: write one");
  EXPECT_EQ(ErrorOf("P5\n99999 2\n255\n"), "a.pgm:2: width above 4096: make the picture smaller");
  EXPECT_EQ(ErrorOf("P5\n4096 4096\n255\nabc"),
            "a.pgm:4: cut off: 3 bytes of heights, 4096 x 4096 need 16777216: save it again");
  EXPECT_EQ(ErrorOf("P2\n4000 4000\n255\n0"),
            "a.pgm:3: cut off: too short for 4000 x 4000 heights: save it again");
  EXPECT_EQ(ErrorOf("P5\n1 2\n255\nab"), "a.pgm:3: a side of less than 2 samples: give more");
  EXPECT_EQ(ErrorOf("P5\n2 2\n0\nabcd"), "a.pgm:3: a greatest value of 0: write 255, say");
}

}  // namespace
}  // namespace moontrace
