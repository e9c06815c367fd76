#include "textures/field/sampled.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "textures/base/error.h"

namespace moontrace {

namespace {

constexpr std::size_t kMostSamples = 4096;  // along a side

/// Weights of four samples around a place, `t` behind the second, and their derivatives.
struct Weights {
  std::array<double, 4> value, slope;
};

Weights WeightsAt(double t) noexcept {
  const double t2 = t * t, t3 = t2 * t;
  return {{0.5 * (-t + 2 * t2 - t3), 0.5 * (2 - 5 * t2 + 3 * t3), 0.5 * (t + 4 * t2 - 3 * t3),
           0.5 * (t3 - t2)},
          {0.5 * (-1 + 4 * t - 3 * t2), 0.5 * (9 * t2 - 10 * t), 0.5 * (1 + 8 * t - 9 * t2),
           0.5 * (3 * t2 - 2 * t)}};
}

/// The four samples around a place along one axis, and its weights.
struct Around {
  std::array<std::size_t, 4> at{};
  Weights weights;
};

Around Held(double u, std::size_t count) noexcept {
  const double most = static_cast<double>(count - 1);
  const double held = u > 0 ? std::min(u, most) : 0;
  const std::size_t first = std::min(static_cast<std::size_t>(held), count - 2);
  return {{first == 0 ? 0 : first - 1, first, first + 1, std::min(first + 2, count - 1)},
          WeightsAt(held - static_cast<double>(first))};
}

Around Repeated(double u, std::size_t count) noexcept {
  const auto whole = static_cast<std::size_t>(u > 0 ? u : 0);
  const std::size_t first = whole % count;
  const auto after = [count](std::size_t i) { return i + 1 < count ? i + 1 : 0; };
  const std::size_t second = after(first);
  return {{first == 0 ? count - 1 : first - 1, first, second, after(second)},
          WeightsAt(u - static_cast<double>(whole))};
}

HeightSample Bicubic(const std::vector<float>& heights, std::size_t columns, const Around& u,
                     const Around& v) noexcept {
  HeightSample sum;
  for (std::size_t j = 0; j < 4; ++j) {
    const float* row = &heights[v.at[j] * columns];
    double height = 0, slope = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double h = static_cast<double>(row[u.at[i]]);
      height += u.weights.value[i] * h;
      slope += u.weights.slope[i] * h;
    }
    sum.height += v.weights.value[j] * height;
    sum.gradient += glm::dvec2(v.weights.value[j] * slope, v.weights.slope[j] * height);
  }
  return sum;
}

}  // namespace

SampledHeights::SampledHeights(std::size_t columns, std::size_t rows, std::vector<float> heights)
    : columns_(columns), rows_(rows), heights_(std::move(heights)) {
  const bool fits = std::min(columns, rows) >= 2 && std::max(columns, rows) <= kMostSamples;
  if (!fits || heights_.size() != columns * rows) {
    throw InputError(fmt::format("an array of {} x {} heights: give 2 x 2 to {} x {}", columns,
                                 rows, kMostSamples, kMostSamples));
  }
  for (const float height : heights_) {
    if (!(std::abs(height) <= 1)) throw InputError("a height is not a number from -1 to 1");
  }
}

HeightSample SampledHeights::Stretched(double u, double v) const noexcept {
  return Bicubic(heights_, columns_, Held(u, columns_), Held(v, rows_));
}

HeightSample SampledHeights::Tiled(double u, double v) const noexcept {
  return Bicubic(heights_, columns_, Repeated(u, columns_), Repeated(v, rows_));
}

// Written by differences d of neighbouring samples, the slope of a Catmull-Rom segment is
// a d_-1 + b d_0 + c d_1 with a = (1-t)(1-3t)/2, c = t(3t-2)/2, b = 1-a-c; |a| + |b| + |c| <= 3/2,
// at t = 1/2. Its second derivative is linear in t and at its ends 2 e_0 - e_1 and 2 e_1 - e_0 of
// the second differences e: at most 3 of the greatest. The weights of the values sum, as
// magnitudes, to at most 5/4.
SampledHeights::Bounds SampledHeights::GreatestOf(bool tiled) const {
  constexpr double kValue = 1.25, kSlope = 1.5, kBend = 3;
  const auto next = [tiled](std::size_t i, std::size_t count) {
    return i + 1 < count ? i + 1 : tiled ? 0 : i;
  };
  const auto at = [this](std::size_t i, std::size_t j) {
    return static_cast<double>(heights_[j * columns_ + i]);
  };
  Bounds most;
  const auto raise = [](double& greatest, double value) {
    greatest = std::max(greatest, std::abs(value));
  };
  for (std::size_t j = 0; j < rows_; ++j) {
    // held at the lower edge too: there the second difference is the first
    const std::size_t above = next(j, rows_), beyond = next(above, rows_);
    for (std::size_t i = 0; i < columns_; ++i) {
      const std::size_t right = next(i, columns_), further = next(right, columns_);
      const double du = at(right, j) - at(i, j), dv = at(i, above) - at(i, j);
      raise(most.height, at(i, j));
      raise(most.slope.x, du);
      raise(most.slope.y, dv);
      raise(most.uu, at(further, j) - at(right, j) - du);
      raise(most.vv, at(i, beyond) - at(i, above) - dv);
      raise(most.uv, at(right, above) - at(i, above) - du);
      if (!tiled && i == 0) raise(most.uu, du);
      if (!tiled && j == 0) raise(most.vv, dv);
    }
  }
  most.height *= kValue * kValue;
  most.slope *= kSlope * kValue;
  most.uu *= kBend * kValue;
  most.vv *= kBend * kValue;
  most.uv *= kSlope * kSlope;
  return most;
}

}  // namespace moontrace
