#include "textures/field/large_array.h"

#include <sys/mman.h>

#include <cstdint>

namespace moontrace {

namespace {

constexpr std::size_t kLargePage = std::size_t{2} << 20;  // of x86-64 [bytes]
constexpr std::size_t kPages = std::size_t{64} << 10;     // multiple of any ordinary page [bytes]
constexpr std::align_val_t kCacheLine = std::align_val_t(64);

std::uintptr_t RoundedUp(std::uintptr_t value, std::size_t step) noexcept {
  return (value + step - 1) / step * step;
}

/// Fresh memory: what a heap hands out again has its ordinary pages already.
void* Map(std::size_t bytes) {
  const std::size_t room = RoundedUp(bytes, kPages) + kLargePage;
  void* const all = mmap(nullptr, room, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (all == MAP_FAILED) throw std::bad_alloc();
  const auto begin = reinterpret_cast<std::uintptr_t>(all);
  const std::size_t before = RoundedUp(begin, kLargePage) - begin;
  char* const memory = static_cast<char*>(all) + before;
  if (before > 0) munmap(all, before);
  if (before < kLargePage) munmap(memory + RoundedUp(bytes, kPages), kLargePage - before);
#ifdef MADV_HUGEPAGE
  // whole large pages only; where the system has none to give, ordinary ones serve
  madvise(memory, bytes / kLargePage * kLargePage, MADV_HUGEPAGE);
#endif
  return memory;
}

}  // namespace

void* AllocateLarge(std::size_t bytes) {
  return bytes < kLargePage ? ::operator new(bytes, kCacheLine) : Map(bytes);
}

void FreeLarge(void* memory, std::size_t bytes) noexcept {
  if (bytes < kLargePage) {
    ::operator delete(memory, kCacheLine);
  } else {
    munmap(memory, RoundedUp(bytes, kPages));
  }
}

}  // namespace moontrace
