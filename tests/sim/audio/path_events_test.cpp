#include "sim/audio/path_events.h"

#include <gtest/gtest.h>

#include <glm/vec2.hpp>

#include "sim/audio/sound_messages.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

/// A way, moment by moment, 0.1 s apart.
class Way {
 public:
  std::optional<Earcon> To(bool touching, double off_line, PassedEnd end = PassedEnd::kNothing) {
    time_ += 0.1;
    return events_.Take({time_, touching, off_line, end});
  }
  void Wait(double seconds) { time_ += seconds; }

 private:
  PathEvents events_;
  double time_ = 0;
};

TEST(PathEvents, TellBeginAndEndOfTouch) {
  Way way;
  EXPECT_EQ(way.To(false, 0), std::nullopt);
  EXPECT_EQ(way.To(true, 0), Earcon::kStrokeStart);
  EXPECT_EQ(way.To(true, 0), std::nullopt);
  EXPECT_EQ(way.To(false, 0), Earcon::kStrokeEnd);
}

TEST(PathEvents, TellOffTheLineAndBackOnIt) {
  Way way;
  way.To(true, 0);
  EXPECT_EQ(way.To(true, 0.49), std::nullopt);
  EXPECT_EQ(way.To(true, 0.5), Earcon::kOffLine);
  EXPECT_EQ(way.To(true, 0.1), std::nullopt);  // not quite on it
  EXPECT_EQ(way.To(true, 0), Earcon::kBackOn);
}

TEST(PathEvents, TellTheSameOnceInThreeSecondsOnly) {
  Way way;
  way.To(true, 0);
  EXPECT_EQ(way.To(true, 1), Earcon::kOffLine);
  EXPECT_EQ(way.To(true, 0), Earcon::kBackOn);
  EXPECT_EQ(way.To(true, 1), std::nullopt);
  EXPECT_EQ(way.To(true, 0), std::nullopt);
  way.Wait(3);
  EXPECT_EQ(way.To(true, 1), Earcon::kOffLine);
}

TEST(PathEvents, TellTheEndOfALineOnceUntilTheTipIsBack) {
  Way way;
  way.To(true, 0);
  EXPECT_EQ(way.To(true, 0, PassedEnd::kLine), Earcon::kLineEnd);
  way.Wait(10);
  EXPECT_EQ(way.To(true, 0, PassedEnd::kLine), std::nullopt);
  EXPECT_EQ(way.To(true, 0, PassedEnd::kNothing), std::nullopt);
  EXPECT_EQ(way.To(true, 0, PassedEnd::kPage), Earcon::kPageEnd);
}

TEST(PathEvents, OfTheWayAreToldAsTextToo) {
  for (const Earcon earcon :
       {Earcon::kOffLine, Earcon::kBackOn, Earcon::kLineEnd, Earcon::kPageEnd}) {
    EXPECT_FALSE(say::OnThePath(earcon).empty());
    EXPECT_LE(say::OnThePath(earcon).size(), 40U);
  }
}

TEST(PassedEnd, IsBehindTheLastLetterOfALine) {
  const Script script = FindScript("moon");
  const TypeStyle style = DefaultStyle(0.01, Relief::kEngraved, script);
  const Typeset set = SetText("it\nit", script, style, FindPage("a5"));
  const TextPage& page = set.pages.front();
  ASSERT_EQ(page.glyphs.size(), 4U);
  const auto behind = [&](std::size_t letter, double em) {
    const PlacedGlyph& glyph = page.glyphs[letter];
    const double advance = script.glyphs[glyph.glyph].advance;
    return PassedEndOf(page, script, style, glyph.origin_P + 0.01 * glm::dvec2(advance + em, 0.5));
  };
  EXPECT_EQ(behind(0, 0), PassedEnd::kNothing);
  EXPECT_EQ(behind(1, 0), PassedEnd::kNothing);  // at the last letter's own edge
  EXPECT_EQ(behind(1, 0.3), PassedEnd::kLine);
  EXPECT_EQ(behind(3, 0.3), PassedEnd::kPage);
  // far below the text is no line's end
  EXPECT_EQ(PassedEndOf(page, script, style, {0.2, 0.01}), PassedEnd::kNothing);
}

TEST(PassedEnd, IsNoneOfASingleSign) {
  const Script script = FindScript("moon");
  const TypeStyle style = DefaultStyle(0.01, Relief::kEngraved, script);
  const Typeset set = SetText("i", script, style, FindPage("a5"));
  const glm::dvec2 origin_P = set.pages.front().glyphs.front().origin_P;
  EXPECT_EQ(PassedEndOf(set.pages.front(), script, style, origin_P + glm::dvec2(0.05, 0)),
            PassedEnd::kNothing);
}

}  // namespace
}  // namespace moontrace
