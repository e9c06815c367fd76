#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "lessons/measure/scoring.h"

namespace moontrace {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kWidth = 1.2e-3;       // w [m]
inline constexpr double kRadius = kWidth / 4;  // of coverage
inline constexpr double kLength = 0.020;       // of the straight test stroke [m]

inline IntendedStroke Straight(double length = kLength, std::size_t glyph = 0) {
  return {StrokeKind::kStroke, {Line{{0, 0}, {length, 0}}}, kWidth, glyph};
}

/// Feeds samples 1 ms apart.
class Tracer {
 public:
  explicit Tracer(const std::vector<IntendedStroke>& strokes, std::size_t glyphs = 1)
      : scorer_(strokes, glyphs) {}

  void Touch(glm::dvec2 p, TracePhase phase = TracePhase::kStroke, bool contact = true) {
    Touch(p, phase, contact, contact ? 1 : 0);
  }
  /// `force` [N].
  void Touch(glm::dvec2 p, TracePhase phase, bool contact, double force) {
    TraceSample sample;
    sample.time = 0.001 * ticks_++;
    sample.tip_P = {p, -1e-4};
    sample.force_P = {0, 0, force};
    sample.in_contact = contact;
    sample.phase = phase;
    sample.stroke = stroke;
    scorer_.Add(sample);
  }
  /// Follows a way given by a share from 0 to 1, both ends touched.
  void Follow(const std::function<glm::dvec2(double)>& way, int steps = 1000) {
    for (int i = 0; i <= steps; ++i) Touch(way(static_cast<double>(i) / steps));
  }
  void FollowLine(glm::dvec2 from, glm::dvec2 to) {
    Follow([&](double share) { return from + share * (to - from); });
  }
  TraceScore Score() const { return scorer_.Finish(); }

  std::size_t stroke = 0;

 private:
  TraceScorer scorer_;
  int ticks_ = 0;
};

}  // namespace moontrace
