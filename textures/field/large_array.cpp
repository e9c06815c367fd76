#include "textures/field/large_array.h"

#include <sys/mman.h>

namespace moontrace {

namespace {

constexpr std::size_t kLargePage = std::size_t{2} << 20;  // of x86-64 [bytes]

std::align_val_t AlignmentOf(std::size_t bytes) noexcept {
  constexpr std::size_t kCacheLine = 64;
  return std::align_val_t(bytes < kLargePage ? kCacheLine : kLargePage);
}

}  // namespace

void* AllocateLarge(std::size_t bytes) {
  void* memory = ::operator new(bytes, AlignmentOf(bytes));
#ifdef MADV_HUGEPAGE
  // whole large pages only; where the system has none to give, ordinary ones serve
  if (bytes >= kLargePage) madvise(memory, bytes / kLargePage * kLargePage, MADV_HUGEPAGE);
#endif
  return memory;
}

void FreeLarge(void* memory, std::size_t bytes) noexcept {
  ::operator delete(memory, AlignmentOf(bytes));
}

}  // namespace moontrace
