#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

namespace moontrace {

/// FNV-1a, 64 bits, over bytes in order (Fowler, Noll, Vo; offset basis and prime as published).
/// Guards a record against accident: any single changed byte changes the value, since every step is
/// a bijection. It does not guard against malice; whoever wants to forge a record can.
class Digest {
 public:
  void Add(const void* bytes, std::size_t count) noexcept {
    const auto* byte = static_cast<const unsigned char*>(bytes);
    for (std::size_t i = 0; i < count; ++i) AddByte(byte[i]);
  }
  void Add(std::string_view text) noexcept { Add(text.data(), text.size()); }
  /// Its bytes, the least significant first.
  void Add(std::uint64_t word) noexcept {
    for (int byte = 0; byte < 8; ++byte) AddByte((word >> (8 * byte)) & 0xffU);
  }
  /// Its bits as a word.
  void Add(double number) noexcept {
    std::uint64_t bits = 0;
    static_assert(sizeof bits == sizeof number);
    std::memcpy(&bits, &number, sizeof bits);
    Add(bits);
  }
  std::uint64_t value() const noexcept { return value_; }

 private:
  void AddByte(std::uint64_t byte) noexcept { value_ = (value_ ^ byte) * 0x100000001b3U; }
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

inline std::uint64_t DigestOf(std::string_view text) noexcept {
  Digest digest;
  digest.Add(text);
  return digest.value();
}

/// "0x" and sixteen lower-case digits: how digests stand in files.
std::string ToHex(std::uint64_t value);
/// The inverse of ToHex; nothing unless `text` is exactly what ToHex writes.
std::optional<std::uint64_t> FromHex(std::string_view text);

}  // namespace moontrace
