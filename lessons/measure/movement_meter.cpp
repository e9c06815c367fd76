#include "lessons/measure/movement_meter.h"

#include <cmath>

#include "lessons/measure/zero_phase.h"

namespace moontrace {
namespace {

constexpr double kStep = 1 / MovementMeter::kRate;
constexpr auto kMost = static_cast<std::size_t>(MovementMeter::kLongest * MovementMeter::kRate);
constexpr auto kFewest = static_cast<std::size_t>(MovementMeter::kShortest * MovementMeter::kRate);
constexpr std::size_t kGapPoints = 12;  ///< at most, that one sample adds after a gap
constexpr double kHair = 1e-6;          ///< [s]

}  // namespace

MovementMeter::MovementMeter() { grid_.reserve(kMost); }

bool MovementMeter::Takes(double time) const {
  return !any_ || (time - origin_ - last_ <= kGap && grid_.size() + kGapPoints <= kMost);
}

void MovementMeter::Add(double time, glm::dvec2 p) {
  if (!any_) {
    any_ = true;
    origin_ = time;
    last_ = -1;
    bin_end_ = kStep;
  }
  const double since = time - origin_;
  if (!(since > last_)) return;
  last_ = since;
  // A hair before the bin's end, so that even samples fall into even bins.
  if (since >= bin_end_ - kHair) {
    Close();
    while (since >= bin_end_ - kHair) bin_end_ += kStep;
  }
  time_sum_ += since;
  sum_ += p;
  ++count_;
}

void MovementMeter::Close() {
  if (count_ == 0) return;
  const double time = time_sum_ / static_cast<double>(count_);
  const glm::dvec2 p = sum_ / static_cast<double>(count_);
  time_sum_ = 0;
  sum_ = {0, 0};
  count_ = 0;
  if (grid_.empty()) {
    begin_ = time;
    grid_.push_back(p);
  }
  for (;;) {
    const double next = begin_ + static_cast<double>(grid_.size()) * kStep;
    if (next > time + kHair) break;
    grid_.push_back(mean_ + (next - mean_time_) / (time - mean_time_) * (p - mean_));
  }
  mean_time_ = time;
  mean_ = p;
}

void MovementMeter::Clear() {
  grid_.clear();
  any_ = false;
  time_sum_ = 0;
  sum_ = {0, 0};
  count_ = 0;
}

double MovementMeter::duration() const {
  return grid_.size() > kFewest ? static_cast<double>(grid_.size() - 1) * kStep : 0;
}

Smoothness MovementMeter::Measure() const {
  if (!(duration() > 0)) return {};
  std::vector<double> x, y;
  for (const glm::dvec2 p : grid_) {
    x.push_back(p.x);
    y.push_back(p.y);
  }
  x = ZeroPhaseLowPass(x, kRate, kCutoff);
  y = ZeroPhaseLowPass(y, kRate, kCutoff);
  std::vector<double> speeds;
  for (std::size_t i = 1; i < x.size(); ++i) {
    speeds.push_back(kRate * std::hypot(x[i] - x[i - 1], y[i] - y[i - 1]));
  }
  return SmoothnessOf(speeds, kRate);
}

}  // namespace moontrace
