#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

namespace moontrace {

/// What a program in C holds in place of values: numbers that are never those of memory, so that
/// one that is wrong or closed is recognised without a look at memory that may be gone. A value is
/// destroyed once its handle is closed and no call uses it any more. Any thread.
///
/// A handle is its slot's generation (32 bits), the slot's number (28 bits) and the kind (4 bits,
/// not zero). A slot's state is its generation, whether it is open, and how many use it, the owner
/// among them.
template <class Value, std::uint64_t kKind>
class HandleTable {
  static_assert(sizeof(std::uintptr_t) == sizeof(std::uint64_t));
  static_assert(kKind > 0 && kKind < 16);

  static constexpr unsigned kOpenBit = 31;
  static constexpr std::uint64_t kUsers = (std::uint64_t{1} << kOpenBit) - 1;
  static constexpr std::uint64_t kNumber = (std::uint64_t{1} << 28U) - 1;
  static constexpr std::size_t kChunk = 1024, kChunks = 4096;

  struct Slot {
    std::atomic<std::uint64_t> state{std::uint64_t{1} << 32U};
    const Value* value = nullptr;
    std::size_t number = 0;
  };
  using Chunk = std::array<Slot, kChunk>;

 public:
  /// The one table of its kind. It is never destroyed: handles may be used by what runs at the end.
  static HandleTable& Get() {
    static auto* const table = new HandleTable;
    return *table;
  }

  /// Takes the value. Throws std::bad_alloc: no memory, or 4 million handles are open.
  std::uintptr_t Open(std::unique_ptr<const Value> value) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::size_t number = FreeSlot();
    Slot& slot = *Find(number);
    const std::uint64_t generation = slot.state.load(std::memory_order_relaxed) >> kOpenBit >> 1U;
    slot.value = value.release();
    slot.state.store(((generation << 1U) + 1U) << kOpenBit | 1U, std::memory_order_release);
    return generation << 32U | number << 4U | kKind;
  }

  /// Closes a handle; false where it was not open.
  bool Close(std::uintptr_t handle) noexcept {
    Slot* slot = Find(handle >> 4U & kNumber);
    if (slot == nullptr || (handle & 15U) != kKind) return false;
    std::uint64_t state = slot->state.load(std::memory_order_acquire);
    do {
      if (!IsOpen(state, handle)) return false;
    } while (!slot->state.compare_exchange_weak(state, state & ~(std::uint64_t{1} << kOpenBit),
                                                std::memory_order_acq_rel));
    Leave(*slot);
    return true;
  }

  /// A value while a call uses it: null where the handle was not open.
  class Use {
   public:
    Use(HandleTable& table, std::uintptr_t handle) noexcept : table_(table) {
      Slot* slot = table.Find(handle >> 4U & kNumber);
      if (slot == nullptr || (handle & 15U) != kKind) return;
      std::uint64_t state = slot->state.load(std::memory_order_acquire);
      do {
        if (!IsOpen(state, handle)) return;
      } while (!slot->state.compare_exchange_weak(state, state + 1, std::memory_order_acquire));
      slot_ = slot;
    }
    ~Use() {
      if (slot_ != nullptr) table_.Leave(*slot_);
    }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    const Value* get() const noexcept { return slot_ != nullptr ? slot_->value : nullptr; }

   private:
    HandleTable& table_;
    Slot* slot_ = nullptr;
  };

 private:
  static bool IsOpen(std::uint64_t state, std::uintptr_t handle) noexcept {
    return state >> kOpenBit == (handle >> 32U << 1U | 1U);
  }

  Slot* Find(std::size_t number) noexcept {
    if (number >= kChunk * kChunks) return nullptr;
    Chunk* chunk = chunks_[number / kChunk].load(std::memory_order_acquire);
    return chunk != nullptr ? &(*chunk)[number % kChunk] : nullptr;
  }

  /// Under the lock.
  std::size_t FreeSlot() {
    if (free_.empty()) {
      if (used_chunks_ == kChunks) throw std::bad_alloc();
      free_.reserve((used_chunks_ + 1) * kChunk);  // for good: Leave does not allocate
      chunks_[used_chunks_].store(std::make_unique<Chunk>().release(), std::memory_order_release);
      for (std::size_t i = kChunk; i > 0; --i) free_.push_back(used_chunks_ * kChunk + i - 1);
      ++used_chunks_;
    }
    const std::size_t number = free_.back();
    free_.pop_back();
    Find(number)->number = number;
    return number;
  }

  /// One user less; the last one destroys the value and makes the slot another generation's.
  void Leave(Slot& slot) noexcept {
    const std::uint64_t left = slot.state.fetch_sub(1, std::memory_order_acq_rel) - 1;
    if ((left & kUsers) != 0) return;
    delete std::exchange(slot.value, nullptr);
    const std::lock_guard<std::mutex> lock(mutex_);
    slot.state.store(((left >> 32U) + 1) << 32U, std::memory_order_release);
    free_.push_back(slot.number);
  }

  std::mutex mutex_;
  std::vector<std::size_t> free_;
  std::size_t used_chunks_ = 0;
  std::array<std::atomic<Chunk*>, kChunks> chunks_{};
};

}  // namespace moontrace
