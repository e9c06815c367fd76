#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "devices/hid/hid_bits.h"

namespace moontrace {

/// A usage with its page: page << 16 | id.
using HidUsage = std::uint32_t;

enum class HidReportType : std::uint8_t { kInput, kOutput, kFeature };

/// One main item: `count` numbers of equal size, one after the other.
struct HidField {
  HidBits first;  ///< the first of them; the report's byte 0 is its number, 0 if it has none
  std::uint32_t count = 0;
  bool is_constant = false;  ///< padding
  /// True: each number belongs to one usage. False (array): each number tells which usage is on,
  /// first.least the first of `usages`.
  bool is_variable = false;
  /// Variable: one for each number (the last one stands for all that follow); array: the choices.
  /// May be shorter than `count`, or empty.
  std::vector<HidUsage> usages;
  std::vector<HidUsage> collections;  ///< it lies in, outermost first

  /// The i-th number.
  HidBits At(std::uint32_t i) const noexcept;
};

struct HidReportLayout {
  HidReportType type = HidReportType::kInput;
  std::uint8_t id = 0;    ///< 0: the device does not number its reports
  std::size_t bytes = 1;  ///< with byte 0
  std::vector<HidField> fields;
};

/// What a report descriptor says (HID 1.11, section 6.2.2).
struct HidDescriptor {
  bool is_numbered = false;              ///< reports carry their number
  std::vector<HidUsage> applications;    ///< top-level collections
  std::vector<HidReportLayout> reports;  ///< in order of appearance

  const HidReportLayout* Find(HidReportType type, std::uint8_t id) const noexcept;
};

/// Reads a report descriptor of any origin in bounded time and memory. Throws DeviceError, one line
/// with the byte, for what no kernel would take (items cut off, unbalanced collections, absurd
/// sizes); tolerates what only looks odd (ranges, missing usages, long items).
HidDescriptor ParseHidDescriptor(std::span<const std::uint8_t> bytes);

}  // namespace moontrace
