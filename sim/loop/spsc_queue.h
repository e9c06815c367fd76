#pragma once

#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace moontrace {

/// A queue from one thread to one other, allocated once and never grown. Neither side waits: what
/// does not fit is dropped and counted.
template <class T>
class SpscQueue {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// Holds `capacity` or more.
  explicit SpscQueue(std::size_t capacity) : places_(std::bit_ceil(capacity + 1)) {}

  /// The writing thread only.
  void Push(const T& value) noexcept {
    const std::size_t end = end_.load(std::memory_order_relaxed);
    const std::size_t next = (end + 1) & (places_.size() - 1);
    if (next == begin_.load(std::memory_order_acquire)) {
      dropped_.fetch_add(1, std::memory_order_relaxed);
      return;
    }
    places_[end] = value;
    end_.store(next, std::memory_order_release);
  }
  /// The reading thread only: false if there is none.
  bool Pop(T& value) noexcept {
    const std::size_t begin = begin_.load(std::memory_order_relaxed);
    if (begin == end_.load(std::memory_order_acquire)) return false;
    value = places_[begin];
    begin_.store((begin + 1) & (places_.size() - 1), std::memory_order_release);
    return true;
  }
  /// Any thread.
  std::uint64_t dropped() const noexcept { return dropped_.load(std::memory_order_relaxed); }

 private:
  std::vector<T> places_;
  alignas(64) std::atomic<std::size_t> begin_{0};
  alignas(64) std::atomic<std::size_t> end_{0};
  std::atomic<std::uint64_t> dropped_{0};
};

}  // namespace moontrace
