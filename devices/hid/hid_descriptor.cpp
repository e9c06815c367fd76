#include "devices/hid/hid_descriptor.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

#include "devices/core/device_error.h"

namespace moontrace {
namespace {

// Bounds of what we take; the kernel's own are 4096 bytes, 256 fields a report, 4 pushes.
constexpr std::size_t kMostDescriptor = 4096;   // [bytes]
constexpr std::size_t kMostReportBits = 32768;  // 4096 bytes, uhid's limit
constexpr std::size_t kMostDepth = 32;          // nested collections
constexpr std::size_t kMostPushes = 16;
constexpr std::size_t kMostUsages = 1024;      // of one item
constexpr std::size_t kMostAllUsages = 16384;  // of the whole descriptor

/// A short item (6.2.2.2).
struct Item {
  std::size_t at = 0;
  std::uint32_t type = 0, tag = 0, size = 0, data = 0;
};

enum Type : std::uint32_t { kMain = 0, kGlobal = 1, kLocal = 2 };

struct Globals {
  std::uint32_t page = 0, size = 0, count = 0, id = 0;
  Item least, most;
};

struct Locals {
  /// A usage as it stands; the page of a short one is the one in force at the main item.
  struct Usage {
    std::uint32_t data = 0;
    bool is_full = false;
  };
  std::vector<Usage> usages;
  Usage first;                               // of a range
  bool in_set = false, set_has_one = false;  // delimiters: alternatives, of which the first counts
};

std::int64_t Signed(const Item& item) noexcept {
  if (item.size == 0) return 0;
  const std::uint32_t bits = 8 * item.size;
  const std::int64_t value = item.data;
  return (item.data >> (bits - 1) & 1) != 0 ? value - (std::int64_t{1} << bits) : value;
}

class Parser {
 public:
  explicit Parser(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  HidDescriptor Parse() {
    if (bytes_.empty()) Fail(0, "is empty");
    if (bytes_.size() > kMostDescriptor) Fail(kMostDescriptor, "is longer than 4096 bytes");
    for (at_ = 0; at_ < bytes_.size();) {
      Item item;
      if (!Next(item)) continue;
      if (item.type == kMain) {
        OnMain(item);
      } else if (item.type == kGlobal) {
        OnGlobal(item);
      } else if (item.type == kLocal) {
        OnLocal(item);
      }
    }
    if (!collections_.empty()) Fail(at_, "ends inside a collection");
    Finish();
    return std::move(out_);
  }

 private:
  [[noreturn]] static void Fail(std::size_t at, std::string_view what) {
    throw DeviceError(fmt::format(
        "report descriptor, byte {}: {}: the device's firmware is at fault, update it", at, what));
  }

  /// Pads over Bluetooth list that many, sticks that push a hundredth of it.
  [[noreturn]] static void FailByUsages(std::size_t at) {
    throw DeviceError(fmt::format(
        "report descriptor, byte {}: has too many usages: it is no force-feedback device", at));
  }

  /// False for a long item, which nobody has defined: skipped.
  bool Next(Item& item) {
    const std::uint32_t prefix = bytes_[at_];
    const std::size_t left = bytes_.size() - at_ - 1;
    if (prefix == 0xfe) {
      const std::size_t length = left >= 2 ? std::size_t{bytes_[at_ + 1]} + 2 : left + 1;
      if (length > left) Fail(at_, "a long item is cut off");
      at_ += 1 + length;
      return false;
    }
    item = {at_, prefix >> 2 & 3, prefix >> 4, (prefix & 3) == 3 ? 4 : prefix & 3, 0};
    if (item.size > left) Fail(at_, "an item is cut off");
    for (std::uint32_t i = 0; i < item.size; ++i) {
      item.data |= static_cast<std::uint32_t>(bytes_[at_ + 1 + i]) << (8 * i);
    }
    at_ += 1 + item.size;
    return true;
  }

  void OnGlobal(const Item& item) {
    switch (item.tag) {
      case 0x0:
        globals_.page = item.data & 0xffff;
        break;
      case 0x1:
        globals_.least = item;
        break;
      case 0x2:
        globals_.most = item;
        break;
      case 0x7:
        globals_.size = item.data;
        break;
      case 0x8:
        if (item.data == 0 || item.data > 255) Fail(item.at, "a report number is not 1 to 255");
        globals_.id = item.data;
        break;
      case 0x9:
        globals_.count = item.data;
        break;
      case 0xa:
        if (stack_.size() == kMostPushes) Fail(item.at, "pushes too often");
        stack_.push_back(globals_);
        break;
      case 0xb:
        if (stack_.empty()) Fail(item.at, "pops what was never pushed");
        globals_ = stack_.back();
        stack_.pop_back();
        break;
      default:
        break;  // physical range, unit, exponent: not needed
    }
  }

  void AddUsage(const Item& item, Locals::Usage usage) {
    if (locals_.in_set) {
      if (locals_.set_has_one) return;
      locals_.set_has_one = true;
    }
    if (locals_.usages.size() == kMostUsages) FailByUsages(item.at);
    locals_.usages.push_back(usage);
  }

  void OnLocal(const Item& item) {
    const Locals::Usage usage{item.data, item.size == 4};
    if (item.tag == 0x0) AddUsage(item, usage);
    if (item.tag == 0x1) locals_.first = usage;
    if (item.tag == 0x2) {
      // A range may be 65536 long; no more is kept than an item can hold.
      for (std::uint32_t u = locals_.first.data;
           u <= item.data && locals_.usages.size() < kMostUsages; ++u) {
        AddUsage(item, {u, locals_.first.is_full});
        if (locals_.in_set || u == 0xffffffff) break;
      }
    }
    if (item.tag == 0xa) {
      locals_.in_set = item.data == 1;
      locals_.set_has_one = false;
    }
  }

  HidUsage Full(Locals::Usage usage) const noexcept {
    return usage.is_full ? usage.data : globals_.page << 16 | (usage.data & 0xffff);
  }

  void OnMain(const Item& item) {
    if (item.tag == 0xa) {
      if (collections_.size() == kMostDepth) Fail(item.at, "nests collections too deeply");
      collections_.push_back(locals_.usages.empty() ? 0 : Full(locals_.usages.front()));
      if (collections_.size() == 1) out_.applications.push_back(collections_.front());
    } else if (item.tag == 0xc) {
      if (collections_.empty()) Fail(item.at, "ends a collection that never began");
      collections_.pop_back();
    } else if (item.tag == 0x8) {
      AddField(item, HidReportType::kInput);
    } else if (item.tag == 0x9) {
      AddField(item, HidReportType::kOutput);
    } else if (item.tag == 0xb) {
      AddField(item, HidReportType::kFeature);
    }
    locals_ = {};
  }

  HidReportLayout& Report(HidReportType type) {
    const auto id = static_cast<std::uint8_t>(globals_.id);
    for (HidReportLayout& report : out_.reports) {
      if (report.type == type && report.id == id) return report;
    }
    bits_.push_back(0);
    HidReportLayout report;
    report.type = type;
    report.id = id;
    return out_.reports.emplace_back(std::move(report));
  }

  /// Usages by number for variables, choices for arrays.
  std::vector<HidUsage> FieldUsages(const Item& item, bool is_variable) {
    std::size_t n = locals_.usages.size();
    if (is_variable) n = std::min<std::size_t>(n, globals_.count);
    all_usages_ += n;
    if (all_usages_ > kMostAllUsages) FailByUsages(item.at);
    std::vector<HidUsage> usages;
    usages.reserve(n);
    for (std::size_t i = 0; i < n; ++i) usages.push_back(Full(locals_.usages[i]));
    return usages;
  }

  void AddField(const Item& item, HidReportType type) {
    if (globals_.size > 256) Fail(item.at, "a number has more than 256 bits");
    HidReportLayout& report = Report(type);
    std::size_t& bits = bits_[static_cast<std::size_t>(&report - out_.reports.data())];
    const std::uint64_t more = std::uint64_t{globals_.size} * globals_.count;
    if (bits + more > kMostReportBits) Fail(item.at, "a report is longer than 4096 bytes");
    HidField field;
    field.first.bit = static_cast<std::uint32_t>(8 + bits);
    // Numbers of more than 32 bits are somebody's raw data: they keep their place, nobody reads
    // them.
    field.first.size = static_cast<std::uint8_t>(globals_.size <= 32 ? globals_.size : 0);
    field.first.least = Signed(globals_.least);
    // Many firmwares write 255 in one byte, which is -1: a range that begins at 0 has no sign.
    field.first.most = field.first.least < 0 ? Signed(globals_.most) : globals_.most.data;
    field.count = globals_.count;
    field.is_constant = (item.data & 1) != 0;
    field.is_variable = (item.data & 2) != 0;
    field.usages = FieldUsages(item, field.is_variable);
    field.collections = collections_;
    bits += more;
    if (!field.is_constant && more > 0) report.fields.push_back(std::move(field));
  }

  void Finish() {
    for (std::size_t i = 0; i < out_.reports.size(); ++i) {
      out_.reports[i].bytes = 1 + (bits_[i] + 7) / 8;
      out_.is_numbered = out_.is_numbered || out_.reports[i].id != 0;
    }
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  Globals globals_;
  Locals locals_;
  std::vector<Globals> stack_;
  std::vector<HidUsage> collections_;
  std::vector<std::size_t> bits_;  // of each report so far
  std::size_t all_usages_ = 0;
  HidDescriptor out_;
};

}  // namespace

HidBits HidField::At(std::uint32_t i) const noexcept {
  HidBits bits = first;
  bits.bit += i * first.size;
  return bits;
}

const HidReportLayout* HidDescriptor::Find(HidReportType type, std::uint8_t id) const noexcept {
  const auto found = std::find_if(reports.begin(), reports.end(), [&](const auto& report) {
    return report.type == type && report.id == id;
  });
  return found != reports.end() ? &*found : nullptr;
}

HidDescriptor ParseHidDescriptor(std::span<const std::uint8_t> bytes) {
  return Parser(bytes).Parse();
}

}  // namespace moontrace
