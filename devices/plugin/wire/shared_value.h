#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace moontrace {

/// The newest value from one process to another, in memory that both map: a sequence lock (Boehm
/// 2012), odd while the value is being written. The reader writes nothing, so it can map the memory
/// for reading only and a wild writer harms nothing but the value. Zero bytes are a good start.
template <class T>
class SharedValue {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(std::uint64_t) == 0);
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free, "valid across processes");

 public:
  /// One thread of the writing process only.
  void Put(const T& value) noexcept {
    Words words;
    std::memcpy(words.data(), &value, sizeof value);
    const std::uint64_t count = count_.load(std::memory_order_relaxed);
    count_.store(count + 1, std::memory_order_relaxed);
    for (std::size_t i = 0; i < words.size(); ++i) {
      words_[i].store(words[i], std::memory_order_release);
    }
    count_.store(count + 2, std::memory_order_release);
  }

  /// True and the newest value, or false if there is none but the one of `seen`, which the reader
  /// keeps between calls and starts at 0, or if the writer was writing at every try.
  bool Take(T& value, std::uint64_t& seen) const noexcept {
    for (int tries = 0; tries < 64; ++tries) {
      const std::uint64_t count = count_.load(std::memory_order_acquire);
      if (count == seen) return false;
      if (count % 2 != 0) continue;
      Words words;
      for (std::size_t i = 0; i < words.size(); ++i) {
        words[i] = words_[i].load(std::memory_order_acquire);
      }
      if (count_.load(std::memory_order_relaxed) != count) continue;
      std::memcpy(static_cast<void*>(&value), words.data(), sizeof value);
      seen = count;
      return true;
    }
    return false;
  }

 private:
  using Words = std::array<std::uint64_t, sizeof(T) / sizeof(std::uint64_t)>;
  std::atomic<std::uint64_t> count_{0};
  std::array<std::atomic<std::uint64_t>, sizeof(T) / sizeof(std::uint64_t)> words_{};
};

}  // namespace moontrace
