#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace moontrace {

/// One HID device as the system lists it: entries of the same path are one device.
struct HidInfo {
  std::string path;
  std::uint16_t vendor = 0, product = 0;
  std::string maker, name, serial;  ///< UTF-8, empty if unknown
  struct Usage {
    std::uint16_t page = 0, id = 0;
  };
  std::vector<Usage> usages;  ///< of its top-level collections
};

/// False if this program was built without hidapi; then every call below finds nothing or throws.
bool HidIsBuiltIn();

/// Everything that is plugged in. Needs no permission. Never throws for a device's sake.
std::vector<HidInfo> ListHid();

/// The report descriptor of a listed device, at most 4096 bytes. Needs no permission. For tests,
/// the environment variable MOONTRACE_HIDRAW_SYSFS names a folder that is read instead of
/// /sys/class/hidraw. Throws DeviceError: not readable.
std::vector<std::uint8_t> ReportDescriptorOf(const std::string& path);

/// One open handle. One thread at a time: for reading and writing at once open the path twice.
/// Every call can block (writes and features up to seconds): I/O threads only.
class HidHandle {
 public:
  /// Throws DeviceError; PermissionError, with the udev line that mends it, where it is refused.
  static HidHandle Open(const std::string& path);

  /// Bytes read into `report` (first the report's number if the device numbers its reports); 0 if
  /// none came in time; -1 if the device is gone.
  int Read(std::span<std::uint8_t> report, int milliseconds) noexcept;
  /// Byte 0 is the report's number, 0 if the device does not number them. False if the device is
  /// gone.
  bool Write(std::span<const std::uint8_t> report) noexcept;
  /// Byte 0 is the report's number. Bytes got with it, or -1.
  int GetFeature(std::span<std::uint8_t> report) noexcept;
  bool SendFeature(std::span<const std::uint8_t> report) noexcept;

  HidHandle(HidHandle&&) noexcept;
  HidHandle& operator=(HidHandle&&) noexcept;
  ~HidHandle();

 private:
  struct Closer {
    void operator()(void* handle) const noexcept;
  };
  explicit HidHandle(void* handle) : handle_(handle) {}
  std::unique_ptr<void, Closer> handle_;
};

}  // namespace moontrace
