#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace moontrace {

/// Memory for `bytes` that, where there are megabytes, lies in the processor's large pages if the
/// system grants them: a query that leaps about in a book then finds its place without first
/// walking the page tables. Throws std::bad_alloc.
void* AllocateLarge(std::size_t bytes);
void FreeLarge(void* memory, std::size_t bytes) noexcept;

/// For vectors that a book makes large.
template <class T>
struct LargeAllocator {
  using value_type = T;  // NOLINT(readability-identifier-naming): as allocators are to call it
  LargeAllocator() = default;
  template <class U>
  LargeAllocator(const LargeAllocator<U>&) noexcept {}
  T* allocate(std::size_t count) {
    if (count > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(AllocateLarge(count * sizeof(T)));
  }
  void deallocate(T* memory, std::size_t count) noexcept { FreeLarge(memory, count * sizeof(T)); }
  bool operator==(const LargeAllocator&) const noexcept { return true; }
};
template <class T>
using LargeArray = std::vector<T, LargeAllocator<T>>;

}  // namespace moontrace
