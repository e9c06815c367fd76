#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>

#include "sim/library/call.h"

namespace moontrace {

/// Arrays of a caller's, wherever their numbers lie, as columns: block by block where the caller
/// has them if they follow each other there, else copied.

inline constexpr std::size_t kBlock = 512;  ///< numbers that are copied at a time: they stay near

/// Doubles of a caller, some bytes apart. Their addresses may be any, so they are copied one by
/// one.
template <class Byte>
class Strided {
 public:
  /// Throws UsageError: NULL, or longer than any memory.
  Strided(Byte* first, std::ptrdiff_t step, std::size_t count, const char* name)
      : first_(first), step_(step) {
    if (first == nullptr && count > 0) throw UsageError(std::string(name) + " is NULL");
    const std::size_t length =
        step < 0 ? 0 - static_cast<std::size_t>(step) : static_cast<std::size_t>(step);
    constexpr auto kMost = static_cast<std::size_t>(std::numeric_limits<std::ptrdiff_t>::max());
    if (length > 0 && count > kMost / length) {
      throw UsageError(std::string(name) + " is longer than any memory");
    }
  }
  double Get(std::size_t i) const noexcept {
    double value = 0;
    std::memcpy(&value, At(i), sizeof value);
    return value;
  }
  void Set(std::size_t i, double value) const noexcept { std::memcpy(At(i), &value, sizeof value); }
  Byte* At(std::size_t i) const noexcept { return first_ + static_cast<std::ptrdiff_t>(i) * step_; }
  std::ptrdiff_t step() const noexcept { return step_; }
  /// Whether they are an array of doubles.
  bool follow() const noexcept {
    return step_ == sizeof(double) &&
           reinterpret_cast<std::uintptr_t>(first_) % alignof(double) == 0;
  }

 private:
  Byte* first_;
  std::ptrdiff_t step_;
};

using Input = Strided<const char>;
using Output = Strided<char>;

inline Input InputOf(const double* first, std::ptrdiff_t step, std::size_t count,
                     const char* name) {
  return {reinterpret_cast<const char*>(first), step, count, name};
}

/// None where it is not wanted. Throws UsageError where numbers would lie over each other.
inline std::optional<Output> OutputOf(double* first, std::ptrdiff_t step, std::size_t count,
                                      const char* name) {
  if (first == nullptr || count == 0) return std::nullopt;
  constexpr std::ptrdiff_t kWidth = sizeof(double);
  if (count > 1 && step > -kWidth && step < kWidth) {
    throw UsageError(std::string(name) + "_step is less than a number's width");
  }
  return Output(reinterpret_cast<char*>(first), step, count, name);
}

/// A column that is read.
class InColumn {
 public:
  explicit InColumn(const Input& input) noexcept : input_(input), in_place_(input.follow()) {}
  /// Whether the caller's own numbers are read, however many at a time.
  bool in_place() const noexcept { return in_place_; }
  /// At most kBlock numbers from `first` on if they are not, until the next call.
  const double* From(std::size_t first, std::size_t count) noexcept {
    if (in_place_) return reinterpret_cast<const double*>(input_.At(first));
    for (std::size_t i = 0; i < count; ++i) own_[i] = input_.Get(first + i);
    return own_.data();
  }

 private:
  Input input_;
  bool in_place_;
  std::array<double, kBlock> own_;
};

/// A column that is written, or one that nobody wants.
class OutColumn {
 public:
  explicit OutColumn(const std::optional<Output>& output) noexcept
      : output_(output), in_place_(output && output->follow()) {}
  /// Whether the caller's own numbers are written, however many at a time.
  bool in_place() const noexcept { return in_place_; }
  /// Room from `first` on, for at most kBlock numbers if they are not.
  double* From(std::size_t first) noexcept {
    return in_place_ ? reinterpret_cast<double*>(output_->At(first)) : own_.data();
  }
  /// Hands over those that were written there.
  void Put(std::size_t first, std::size_t count) const noexcept {
    if (in_place_ || !output_) return;
    for (std::size_t i = 0; i < count; ++i) output_->Set(first + i, own_[i]);
  }

 private:
  std::optional<Output> output_;
  bool in_place_;
  std::array<double, kBlock> own_;
};

/// False if one of them is not finite, since then no sum is; or, rarely, if a sum is too large. In
/// sums that do not wait for each other, as vectors have them.
inline bool AllSurelyFinite(const double* numbers, std::size_t count) noexcept {
  constexpr std::size_t kSums = 16;
  std::array<double, kSums> sums{};
  std::size_t i = 0;
  for (; i + kSums <= count; i += kSums) {
    for (std::size_t k = 0; k < kSums; ++k) sums[k] += numbers[i + k];
  }
  for (; i < count; ++i) sums[0] += numbers[i];
  double sum = 0;
  for (const double part : sums) sum += part;
  return std::isfinite(sum);
}

/// The number of the first point that is not finite, over all blocks.
class FirstBad {
 public:
  /// Columns of a block's points: each holds `count` numbers, the first those of point `first`.
  template <class... Column>
  void Look(std::size_t first, std::size_t count, const Column*... columns) noexcept {
    if (number_ || (AllSurelyFinite(columns, count) && ...)) return;
    for (std::size_t i = 0; i < count; ++i) {
      if ((std::isfinite(columns[i]) && ...)) continue;
      number_ = first + i;
      return;
    }
  }
  /// The same of points that stand as pairs.
  void LookAtPairs(std::size_t first, std::size_t count, const double* pairs) noexcept {
    if (number_ || AllSurelyFinite(pairs, 2 * count)) return;
    for (std::size_t i = 0; i < count; ++i) {
      if (std::isfinite(pairs[2 * i]) && std::isfinite(pairs[2 * i + 1])) continue;
      number_ = first + i;
      return;
    }
  }
  /// Throws UsageError if there was one.
  void Tell() const {
    if (number_) throw UsageError("point " + std::to_string(*number_) + " is not finite");
  }

 private:
  std::optional<std::size_t> number_;
};

}  // namespace moontrace
