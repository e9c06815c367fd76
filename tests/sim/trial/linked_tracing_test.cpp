// With links on, the simulated stylus traces whole lines like cursive.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <string>

#include "sim/trial/trial.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

/// The links of a line of text that the hand left, of one seed.
std::size_t LinksLeft(const std::string& text, double size, std::uint64_t seed) {
  const Script script = FindScript("moon");
  TrialSetup setup;
  setup.script = &script;
  setup.style = DefaultStyle(size, Relief::kEngraved, script);
  setup.style.links.reach = LinkReach::kWords;
  const Typeset set = SetText(text, script, setup.style, {"custom", 0.6, 0.1, 0.02});
  setup.page = &set.pages.front();
  setup.hand = ShippedHand();
  setup.plan.press = setup.hand.press;
  setup.seed = seed;
  return RunTrial(setup).links_left.value().size();
}

// The link behind H leaves its ring, where the hand comes from the fill.
TEST(LinkedTracing, KeepsTheLinksBehindAHalfFilledRing) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EXPECT_EQ(LinksLeft("ship", 0.012, seed), 0u) << seed;
    EXPECT_EQ(LinksLeft("bright", 0.012, seed), 0u) << seed;
  }
}

class SlowLinkedTracing : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Sizes, SlowLinkedTracing, ::testing::Values(0.020, 0.012));

TEST_P(SlowLinkedTracing, CoversAPangramWithoutLiftingWithinALine) {
  const Script script = FindScript("moon");
  TrialSetup setup;
  setup.script = &script;
  setup.style = DefaultStyle(GetParam(), Relief::kEngraved, script);
  setup.style.links.reach = LinkReach::kWords;
  const Typeset set = SetText("the quick brown fox jumps over the lazy dog", script, setup.style,
                              {"custom", 0.6, 2.0, 0.02});
  setup.page = &set.pages.front();
  setup.hand = ShippedHand();
  setup.plan.press = setup.hand.press;
  for (setup.seed = 1; setup.seed <= 5; ++setup.seed) {
    const TrialResult result = RunTrial(setup);
    ASSERT_TRUE(result.links_left);
    const std::size_t left = result.links_left->size();
    const std::size_t links = set.pages.front().glyphs.size() - result.lines;
    std::printf(
        "%2.0f mm, seed %d: coverage %.4f, lifted %d times in %d lines, %d of %d links left\n",
        1e3 * GetParam(), static_cast<int>(setup.seed), result.score.total.coverage,
        static_cast<int>(result.lifts_within_lines), static_cast<int>(result.lines),
        static_cast<int>(left), static_cast<int>(links));
    EXPECT_LE(5 * left, links) << setup.seed;
    EXPECT_GE(result.score.total.coverage, 0.98) << setup.seed;
    EXPECT_EQ(result.lifts_within_lines, 0u) << setup.seed;
  }
}

}  // namespace
}  // namespace moontrace
