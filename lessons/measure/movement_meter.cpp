#include "lessons/measure/movement_meter.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "textures/base/units.h"

namespace moontrace {
namespace {

constexpr double kStep = 1 / MovementMeter::kRate;
constexpr auto kMost = static_cast<std::size_t>(MovementMeter::kLongest * MovementMeter::kRate);
constexpr auto kFewest = static_cast<std::size_t>(MovementMeter::kShortest * MovementMeter::kRate);
constexpr std::size_t kGapPoints = 12;  ///< at most, that one sample adds after a gap
constexpr double kHair = 1e-6;          ///< [s]

/// y(n) = b (x(n) + 2 x(n-1) + x(n-2)) - a1 y(n-1) - a2 y(n-2), by the bilinear transform.
struct Biquad {
  double b = 0, a1 = 0, a2 = 0;
};

Biquad Butterworth(double rate, double cutoff) {
  const double k = std::tan(kTurn / 2 * cutoff / rate);
  const double scale = 1 / (1 + std::sqrt(2.0) * k + k * k);
  return {k * k * scale, 2 * (k * k - 1) * scale, (1 - std::sqrt(2.0) * k + k * k) * scale};
}

/// In place; begins as if the first value had always been there.
void Run(const Biquad& filter, std::vector<double>& values) {
  const double rest = values.front();
  double x1 = 0, x2 = 0, y1 = 0, y2 = 0;
  for (double& value : values) {
    const double x = value - rest;
    const double y = filter.b * (x + 2 * x1 + x2) - filter.a1 * y1 - filter.a2 * y2;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = y;
    value = y + rest;
  }
}

}  // namespace

std::vector<double> ZeroPhaseLowPass(const std::vector<double>& values, double rate,
                                     double cutoff) {
  if (values.size() < 2 || !(cutoff < rate / 2)) return values;
  // Three periods of the cut-off: what is left of the start has faded by then.
  const auto wanted = static_cast<std::size_t>(std::ceil(3 * rate / cutoff));
  const std::size_t pad = std::min(wanted, values.size() - 1);
  std::vector<double> padded;
  padded.reserve(values.size() + 2 * pad);
  for (std::size_t i = pad; i > 0; --i) padded.push_back(2 * values.front() - values[i]);
  padded.insert(padded.end(), values.begin(), values.end());
  for (std::size_t i = 1; i <= pad; ++i) {
    padded.push_back(2 * values.back() - values[values.size() - 1 - i]);
  }
  const Biquad filter = Butterworth(rate, cutoff);
  for (int pass = 0; pass < 2; ++pass) {
    Run(filter, padded);
    std::reverse(padded.begin(), padded.end());
  }
  const auto begin = padded.begin() + static_cast<std::ptrdiff_t>(pad);
  return {begin, begin + static_cast<std::ptrdiff_t>(values.size())};
}

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

PauseMeter::Step PauseMeter::Add(double time, glm::dvec2 p) {
  Step step;
  if (!any_) {
    any_ = true;
    rest_ = p;
    since_ = last_ = time;
    pausing_ = went_on_ = false;
    return step;
  }
  if (glm::distance(p, rest_) > kSpeed * kLeast) {
    since_ = pausing_ ? last_ : time;
    went_on_ = pausing_;
    pausing_ = false;
    rest_ = p;
  } else if (pausing_) {
    step.time = time - last_;
  } else if (time - since_ > kLeast) {
    pausing_ = true;
    step.began = !went_on_;
    step.time = time - since_;
  }
  last_ = time;
  return step;
}

}  // namespace moontrace
