#include "lessons/measure/link_meter.h"

#include <gtest/gtest.h>

#include <glm/vec3.hpp>

namespace moontrace {
namespace {

constexpr double kWidth = 0.002;  // [m]

/// Two upright strokes 20 mm apart, of two letters, and a straight link between their feet.
class LinkMeterTest : public testing::Test {
 protected:
  LinkMeterTest() {
    strokes_.push_back({StrokeKind::kStroke, {Line{{0, 0.01}, {0, 0}}}, kWidth, 0});
    strokes_.push_back({StrokeKind::kStroke, {Line{{0.02, 0}, {0.02, 0.01}}}, kWidth, 1});
    links_.shapes.push_back({{Line{{0, 0}, {0.02, 0}}}, 0, 0, LineKind::kPlain});
    links_.links.push_back({0, 0, 1, {0, 0}});
  }

  /// Down the first stroke, over to the second with the tip `aside` of the link between, up.
  std::vector<Excursion> Trace(double aside, bool in_contact = true) const {
    LinkMeter meter(strokes_, links_);
    TraceSample sample;
    const auto add = [&](TracePhase phase, std::size_t stroke, glm::dvec3 tip_P) {
      sample.time += 1e-3;
      sample.tip_P = tip_P;
      sample.phase = phase;
      sample.stroke = stroke;
      meter.Add(sample);
    };
    sample.in_contact = true;
    for (int i = 0; i <= 10; ++i) add(TracePhase::kStroke, 0, {0, 0.01 - i * 1e-3, 0});
    sample.in_contact = in_contact;
    for (int i = 0; i <= 20; ++i) {
      add(TracePhase::kTravel, 1, {i * 1e-3, i > 5 && i < 15 ? aside : 0, 0});
    }
    sample.in_contact = true;
    for (int i = 0; i <= 10; ++i) add(TracePhase::kStroke, 1, {0.02, i * 1e-3, 0});
    return meter.left();
  }

  std::vector<IntendedStroke> strokes_;
  GrooveLinks links_;
};

TEST_F(LinkMeterTest, CountsALinkThatWasLeftOnceAndTellsWhere) {
  const std::vector<Excursion> left = Trace(0.51 * kWidth);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_DOUBLE_EQ(left[0].p_P.x, 0.006);
  EXPECT_EQ(left[0].stroke, 1U);
}

TEST_F(LinkMeterTest, CountsNothingWithinHalfAGroove) {
  EXPECT_TRUE(Trace(0).empty());
  EXPECT_TRUE(Trace(0.49 * kWidth).empty());
}

// A dot is flat as far as it reaches: no wall within it holds a tip.
TEST_F(LinkMeterTest, CountsNothingWithinADot) {
  strokes_[0].kind = StrokeKind::kDot;
  strokes_[0].spine_P = {Line{{0, 0}, {0, 0}}};
  links_.shapes[0].spine = {Line{{0, 0}, {0.02, 0}}};
  const auto left_at = [&](double aside) {
    LinkMeter meter(strokes_, links_);
    TraceSample sample;
    sample.in_contact = true;
    sample.tip_P = {0, 0, 0};
    sample.phase = TracePhase::kStroke;
    meter.Add(sample);
    sample.phase = TracePhase::kTravel;
    sample.stroke = 1;
    sample.tip_P = {0, aside, 0};
    meter.Add(sample);
    return meter.left().size();
  };
  strokes_[0].dot_radius = 0.9 * kWidth;
  EXPECT_EQ(left_at(0.89 * kWidth), 0U);
  EXPECT_EQ(left_at(0.91 * kWidth), 1U);
}

TEST_F(LinkMeterTest, CountsNothingInTheAir) { EXPECT_TRUE(Trace(2 * kWidth, false).empty()); }

TEST_F(LinkMeterTest, CountsNothingWithoutALink) {
  links_.links.clear();
  EXPECT_TRUE(Trace(2 * kWidth).empty());
}

}  // namespace
}  // namespace moontrace
