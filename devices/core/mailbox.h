#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace moontrace {

/// The newest value from one thread to one other: three slots, of which each side holds one and the
/// third is exchanged. Neither side ever waits; older values are overwritten.
template <class T>
class Mailbox {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// The writing thread only.
  void Put(const T& value) noexcept {
    places_[back_] = value;
    back_ = middle_.exchange(static_cast<std::uint8_t>(back_ | kNew), std::memory_order_acq_rel) &
            kPlace;
  }
  /// The reading thread only: true and the newest value, or false if there is none since the last.
  bool Take(T& value) noexcept {
    if ((middle_.load(std::memory_order_relaxed) & kNew) == 0) return false;
    front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kPlace;
    value = places_[front_];
    return true;
  }

 private:
  static constexpr std::uint8_t kPlace = 3;
  static constexpr std::uint8_t kNew = 4;
  std::array<T, 3> places_{};
  std::uint8_t back_ = 0;   ///< the writer's
  std::uint8_t front_ = 1;  ///< the reader's
  std::atomic<std::uint8_t> middle_{2};
};

}  // namespace moontrace
