#include "sim/library/call.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <exception>
#include <new>

#include "sim/library/moontrace.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

constexpr std::size_t kMostMessage = 1024;     // bytes, with the 0 at its end
constexpr std::size_t kGreatestStruct = 4096;  // more than any will ever have

/// No allocation, so that a lack of memory can be told too.
thread_local std::array<char, kMostMessage> message{};

void Keep(std::string_view text) noexcept {
  std::size_t length = std::min(text.size(), kMostMessage - 1);
  // no half character at the end
  while (length < text.size() && length > 0 &&
         (static_cast<unsigned char>(text[length]) >> 6U) == 2)
    --length;
  std::copy_n(text.begin(), length, message.begin());
  message[length] = '\0';
}

}  // namespace

const char* LastMessage() noexcept { return message.data(); }

int AnswerOfException() noexcept {
  try {
    throw;
  } catch (const AnswerError& error) {
    Keep(error.what());
    return error.code();
  } catch (const UsageError& error) {
    Keep(error.what());
    return MOONTRACE_BAD_CALL;
  } catch (const InputError& error) {
    Keep(error.what());
    return MOONTRACE_BAD_INPUT;
  } catch (const LackError& error) {
    Keep(error.what());
    return MOONTRACE_LACKING;
  } catch (const std::bad_alloc&) {
    Keep("not enough memory");
    return MOONTRACE_LACKING;
  } catch (const std::exception& error) {
    Keep(error.what());
    return MOONTRACE_FAULT;
  } catch (...) {
    Keep("an unknown fault");
    return MOONTRACE_FAULT;
  }
}

void RequireNotNull(const void* pointer, const char* name) {
  if (pointer == nullptr) throw UsageError(fmt::format("{} is NULL", name));
}

void ThrowNotOpen(const char* kind, bool null) {
  if (null) throw UsageError(fmt::format("the {} is NULL", kind));
  throw UsageError(fmt::format("this is no {} that is open", kind));
}

void RequireNumber(double value, const char* name, double least) {
  if (!std::isfinite(value)) throw UsageError(fmt::format("{} is not a finite number", name));
  if (value < least) throw UsageError(fmt::format("{} is below {}: {}", name, least, value));
}

bool RequireFlag(std::uint32_t value, const char* name) {
  if (value > 1) throw UsageError(fmt::format("{} is neither 0 nor 1: {}", name, value));
  return value == 1;
}

void CheckStruct(const void* given, std::size_t first, std::size_t known, const char* name) {
  RequireNotNull(given, name);
  std::uint32_t size = 0;
  std::memcpy(&size, given, sizeof size);
  if (size < first || size > kGreatestStruct) {
    throw UsageError(
        fmt::format("{}.size is {}; set it to sizeof the struct, {} here", name, size, known));
  }
  const auto* bytes = static_cast<const unsigned char*>(given);
  if (size > known &&
      std::any_of(bytes + known, bytes + size, [](unsigned char byte) { return byte != 0; })) {
    throw UsageError(
        fmt::format("{} asks for what this version of the library does not know", name));
  }
}

}  // namespace moontrace
