#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "sim/console/console.h"
#include "sim/library/handles.h"

namespace moontrace {

/// What all functions of the C interface share: answers, messages, structs, handles.

/// One line with a code of its own.
class AnswerError : public std::runtime_error {
 public:
  AnswerError(int code, const std::string& line) : std::runtime_error(line), code_(code) {}
  int code() const noexcept { return code_; }

 private:
  int code_;
};

/// Keeps the exception that is being handled as this thread's message, and gives its code.
int AnswerOfException() noexcept;
/// This thread's message; never null.
const char* LastMessage() noexcept;

/// Runs what a function of the interface does; nothing that it throws gets out.
template <class Body>
int Answer(Body&& body) noexcept {
  try {
    body();
    return 0;
  } catch (...) {
    return AnswerOfException();
  }
}

/// Throws UsageError: "NAME is NULL".
void RequireNotNull(const void* pointer, const char* name);
/// Throws UsageError for a handle that is not open.
[[noreturn]] void ThrowNotOpen(const char* kind, bool null);
/// Throws UsageError unless it is finite and, with `least`, no less.
void RequireNumber(double value, const char* name, double least = -INFINITY);
/// Throws UsageError for flags that are neither 0 nor 1.
bool RequireFlag(std::uint32_t value, const char* name);
/// Throws UsageError where a caller's struct has an impossible size, or holds in what this version
/// does not know anything but zero. `first` is its size in the first version, `known` in this one.
void CheckStruct(const void* given, std::size_t first, std::size_t known, const char* name);

/// A struct as a caller of any version gives it; what that version did not have is zero.
template <class Struct>
Struct Given(const Struct* given, std::size_t first, const char* name) {
  CheckStruct(given, first, sizeof(Struct), name);
  Struct known{};
  std::memcpy(&known, given, given->size < sizeof(Struct) ? given->size : sizeof(Struct));
  return known;
}

/// Fills a caller's struct as far as it reaches; its size stays.
template <class Struct>
void Give(Struct known, std::size_t first, const char* name, Struct* to) {
  CheckStruct(to, first, sizeof(Struct), name);
  known.size = to->size;
  std::memcpy(to, &known, to->size < sizeof(Struct) ? to->size : sizeof(Struct));
}

/// What a handle stands for while a call uses it. Throws UsageError: not open.
template <class Table>
class InUse {
 public:
  InUse(const void* handle, const char* kind)
      : use_(Table::Get(), reinterpret_cast<std::uintptr_t>(handle)) {
    if (use_.get() == nullptr) ThrowNotOpen(kind, handle == nullptr);
  }
  const auto& operator*() const noexcept { return *use_.get(); }
  auto operator->() const noexcept { return use_.get(); }

 private:
  typename Table::Use use_;
};

template <class Table>
void CloseHandle(const void* handle, const char* kind) {
  if (handle == nullptr) return;
  if (!Table::Get().Close(reinterpret_cast<std::uintptr_t>(handle))) ThrowNotOpen(kind, false);
}

template <class Table, class Value, class Handle>
void OpenHandle(std::unique_ptr<Value> value, Handle** handle) {
  // a number, not an address: see HandleTable
  *handle = reinterpret_cast<Handle*>(Table::Get().Open(std::move(value)));  // NOLINT
}

}  // namespace moontrace
