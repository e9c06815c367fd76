#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace moontrace {

/// FNV-1a, 64 bits, over bytes in order (Fowler, Noll, Vo; offset basis and prime as published).
/// Guards a record against accident: any single changed byte changes the value, since every step is
/// a bijection. It does not guard against malice; whoever wants to forge a record can.
class Digest {
 public:
  void Add(const void* bytes, std::size_t count) noexcept;
  void Add(std::string_view text) noexcept { Add(text.data(), text.size()); }
  std::uint64_t value() const noexcept { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

std::uint64_t DigestOf(std::string_view text) noexcept;

/// "0x" and sixteen lower-case digits: how digests stand in files.
std::string ToHex(std::uint64_t value);
/// The way back; nothing unless `text` is exactly what ToHex writes.
std::optional<std::uint64_t> FromHex(std::string_view text);

}  // namespace moontrace
