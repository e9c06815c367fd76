#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace moontrace {

/// Counts of durations, log-linear: 64 equal steps to each doubling, so that a percentile is at
/// most 1/64 too high and never too low. Fixed size; adding costs some nanoseconds and allocates
/// nothing. One thread at a time.
class Histogram {
 public:
  /// One duration [us]. Negative values and NaN count as zero, values of 2^40 ns (18 minutes) and
  /// more as 2^40 - 1 ns.
  void Add(double microseconds) noexcept {
    const double held = microseconds > 0 ? std::min(microseconds * 1e3, kGreatest) : 0;
    max_ = std::max(max_, held / 1e3);
    ++counts_[PlaceOf(static_cast<std::uint64_t>(held))];
    ++count_;
  }

  std::uint64_t count() const noexcept { return count_; }
  double max() const noexcept { return max_; }  ///< exact [us]; 0 when empty

  /// The least duration that at least a share `p` (0 to 1) of all durations do not exceed, rounded
  /// up to the next step but not above the greatest [us]; 0 when empty.
  double Percentile(double p) const noexcept {
    const auto wanted = std::max<std::uint64_t>(
        1, static_cast<std::uint64_t>(std::ceil(p * static_cast<double>(count_))));
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < kPlaces && count_ > 0; ++i) {
      seen += counts_[i];
      if (seen >= wanted) return std::min(max_, static_cast<double>(EndOf(i)) / 1e3);
    }
    return max_;
  }

 private:
  static constexpr unsigned kBits = 6;  ///< 64 steps a doubling
  static constexpr std::uint64_t kSteps = std::uint64_t{1} << kBits;
  static constexpr double kGreatest = 1099511627775.0;  ///< 2^40 - 1 [ns]
  static constexpr std::size_t kPlaces = kSteps * (40 - kBits + 1);

  /// Below 64 ns each nanosecond has its place; from there on the leading bit says which doubling
  /// and the six bits behind it which step.
  static std::size_t PlaceOf(std::uint64_t ns) noexcept {
    if (ns < kSteps) return static_cast<std::size_t>(ns);
    const auto doubling = static_cast<unsigned>(std::bit_width(ns)) - 1 - kBits;
    return static_cast<std::size_t>((std::uint64_t{doubling} << kBits) + (ns >> doubling));
  }
  /// The greatest that falls into a place [ns].
  static std::uint64_t EndOf(std::size_t place) noexcept {
    if (place < kSteps) return place;
    const std::uint64_t doubling = (place >> kBits) - 1;
    const std::uint64_t step = place - (doubling << kBits);
    return ((step + 1) << doubling) - 1;
  }

  std::array<std::uint64_t, kPlaces> counts_{};
  std::uint64_t count_ = 0;
  double max_ = 0;
};

}  // namespace moontrace
