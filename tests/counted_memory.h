#pragma once

// Every way to the heap calls OnAllocation, which the including test defines. For executables of
// their own (alone/), since it replaces malloc for the whole process. Sanitizers replace it too:
// with them MOONTRACE_COUNTED_MEMORY is not defined and there is nothing to count.
#include <cerrno>
#include <cstddef>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define MOONTRACE_NO_COUNTING
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define MOONTRACE_NO_COUNTING
#endif

#ifndef MOONTRACE_NO_COUNTING
#define MOONTRACE_COUNTED_MEMORY

void OnAllocation() noexcept;

// operator new of the C++ library comes here too
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) noexcept {
  OnAllocation();
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  OnAllocation();
  return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) noexcept {
  OnAllocation();
  return __libc_realloc(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  OnAllocation();
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  OnAllocation();
  *memory = __libc_memalign(alignment, size);
  return *memory != nullptr ? 0 : ENOMEM;
}
}
#endif
