#include "sim/tutor/tutor_stroke.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "textures/base/finite.h"

namespace moontrace {

namespace {

constexpr double kShortLift = 0.15;      // [s]
constexpr double kLeastTouch = 0.1;      // [s]
constexpr double kLeastPath = 1e-3;      // [m]
constexpr double kTolerance = 2e-5;      // [m]
constexpr std::size_t kLookAhead = 200;  // samples tried behind the last good end

/// Drops points that lie within the tolerance of the straight, even movement between those that
/// stay. From each that stays, the velocities that pass all points since within the tolerance are a
/// box that shrinks; the last point that such a velocity leads to is the next to stay.
RecordedStroke Thinned(const RecordedStroke& all) {
  const double tolerance = kTolerance / std::sqrt(3.0);  // on each axis
  RecordedStroke thin;
  const std::size_t count = all.times.size();
  for (std::size_t from = 0; from < count;) {
    thin.times.push_back(all.times[from]);
    thin.tips_P.push_back(all.tips_P[from]);
    glm::dvec3 low(-std::numeric_limits<double>::infinity());
    glm::dvec3 high(std::numeric_limits<double>::infinity());
    std::size_t next = from + 1;
    for (std::size_t i = from + 1; i < count && i - next <= kLookAhead; ++i) {
      const double dt = all.times[i] - all.times[from];
      const glm::dvec3 v = (all.tips_P[i] - all.tips_P[from]) / dt;
      if (glm::all(glm::greaterThanEqual(v, low)) && glm::all(glm::lessThanEqual(v, high))) {
        next = i;
      }
      low = glm::max(low, v - tolerance / dt);
      high = glm::min(high, v + tolerance / dt);
      if (glm::any(glm::greaterThan(low, high))) break;
    }
    from = next;
  }
  return thin;
}

}  // namespace

StrokeRecorder::StrokeRecorder(double longest) : longest_(longest) {}

void StrokeRecorder::Add(double time, glm::dvec3 tip_P, bool in_contact) {
  if (!std::isfinite(time) || !IsFinite(tip_P)) return;
  if (!samples_.empty() && time <= samples_.back().time) return;
  if (samples_.empty() && !in_contact) return;  // the approach is no part of the stroke
  full_ = full_ || (!samples_.empty() && time - samples_.front().time > longest_);
  if (!full_) samples_.push_back({time, tip_P, in_contact});
}

std::optional<RecordedStroke> StrokeRecorder::Stroke() const {
  std::size_t end = samples_.size();
  while (end > 0 && !samples_[end - 1].in_contact) --end;
  RecordedStroke stroke;
  double touched = 0, path = 0;
  std::size_t last = 0;  // sample in contact
  for (std::size_t i = 0; i < end; ++i) {
    if (!samples_[i].in_contact) continue;
    const bool lifted = i > last + 1;
    if (lifted && samples_[i].time - samples_[last].time >= kShortLift) {
      for (std::size_t k = last + 1; k < i; ++k) {
        stroke.times.push_back(samples_[k].time);
        stroke.tips_P.push_back(samples_[k].tip_P);
      }
    } else if (i > 0) {
      touched += samples_[i].time - samples_[last].time;
      path += glm::length(samples_[i].tip_P - samples_[last].tip_P);
    }
    stroke.times.push_back(samples_[i].time);
    stroke.tips_P.push_back(samples_[i].tip_P);
    last = i;
  }
  if (touched < kLeastTouch || path < kLeastPath) return std::nullopt;
  const double begin = stroke.times.front();
  for (double& time : stroke.times) time -= begin;
  return Thinned(stroke);
}

glm::dvec3 TipAt(const RecordedStroke& stroke, double time) {
  const auto after = std::upper_bound(stroke.times.begin(), stroke.times.end(), time);
  if (after == stroke.times.begin()) return stroke.tips_P.front();
  if (after == stroke.times.end()) return stroke.tips_P.back();
  const auto i = static_cast<std::size_t>(after - stroke.times.begin());
  const double share = (time - stroke.times[i - 1]) / (stroke.times[i] - stroke.times[i - 1]);
  return stroke.tips_P[i - 1] + share * (stroke.tips_P[i] - stroke.tips_P[i - 1]);
}

}  // namespace moontrace
