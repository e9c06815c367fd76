#pragma once

#include <cstdint>
#include <vector>

namespace moontrace::fake {

/// Writes HID report descriptors, items in their shortest form (HID 1.11, section 6.2.2).
class DescriptorWriter {
 public:
  enum Main : std::uint8_t { kInput = 0x80, kOutput = 0x90, kFeature = 0xb0 };
  static constexpr std::uint32_t kArray = 0, kConstant = 1, kVariable = 2;

  DescriptorWriter& Page(std::uint32_t page) { return Item(0x04, page); }
  DescriptorWriter& Usage(std::uint32_t usage) { return Item(0x08, usage); }
  /// Page and usage in one item, whatever the page is.
  DescriptorWriter& FullUsage(std::uint32_t page, std::uint32_t usage) {
    return Long(0x0b, page << 16 | usage);
  }
  DescriptorWriter& UsageRange(std::uint32_t first, std::uint32_t last) {
    return Item(0x18, first).Item(0x28, last);
  }
  DescriptorWriter& Begin(std::uint32_t collection) { return Item(0xa0, collection); }
  DescriptorWriter& End() { return Byte(0xc0); }
  DescriptorWriter& Id(std::uint32_t id) { return Item(0x84, id); }
  DescriptorWriter& Range(std::int32_t least, std::int32_t most) {
    return Signed(0x14, least).Signed(0x24, most);
  }
  DescriptorWriter& Size(std::uint32_t bits, std::uint32_t count) {
    return Item(0x74, bits).Item(0x94, count);
  }
  DescriptorWriter& Field(Main main, std::uint32_t flags) { return Item(main, flags); }

  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  DescriptorWriter& Byte(std::uint32_t byte) {
    bytes_.push_back(static_cast<std::uint8_t>(byte));
    return *this;
  }
  DescriptorWriter& Item(std::uint32_t prefix, std::uint32_t value) {
    if (value < 0x100) return Byte(prefix | 1).Byte(value);
    if (value < 0x10000) return Byte(prefix | 2).Byte(value & 0xff).Byte(value >> 8);
    return Long(prefix | 3, value);
  }
  DescriptorWriter& Signed(std::uint32_t prefix, std::int32_t value) {
    const auto bits = static_cast<std::uint32_t>(value);
    if (value >= -0x80 && value < 0x80) return Byte(prefix | 1).Byte(bits & 0xff);
    if (value >= -0x8000 && value < 0x8000) {
      return Byte(prefix | 2).Byte(bits & 0xff).Byte(bits >> 8 & 0xff);
    }
    return Long(prefix | 3, bits);
  }
  DescriptorWriter& Long(std::uint32_t prefix, std::uint32_t value) {
    Byte(prefix);
    for (int shift = 0; shift < 32; shift += 8) Byte(value >> shift & 0xff);
    return *this;
  }

  std::vector<std::uint8_t> bytes_;
};

}  // namespace moontrace::fake
