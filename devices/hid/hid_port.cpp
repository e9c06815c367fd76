#include "devices/hid/hid_port.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <utility>

#include "devices/core/device_error.h"
#include "devices/hid/udev_rule.h"

#ifdef MOONTRACE_HAVE_HIDAPI
#include <hidapi.h>
#include <unistd.h>
#endif

namespace moontrace {

#ifdef MOONTRACE_HAVE_HIDAPI
namespace {

constexpr std::size_t kMostDescriptor = 4096;  // [bytes], what the kernel takes

/// Guards listing and opening, whose errors hidapi keeps in one global without a lock.
std::mutex& HidapiMutex() {
  static std::mutex turn;
  return turn;
}

/// hidapi's wide characters are Unicode scalars here; what is none becomes U+FFFD.
std::string Utf8(const wchar_t* wide) {
  std::string out;
  if (wide == nullptr) return out;
  const auto add = [&out](char32_t byte) { out += static_cast<char>(byte); };
  for (; *wide != 0; ++wide) {
    char32_t c = static_cast<char32_t>(*wide);
    if (c > 0x10ffff || (c >= 0xd800 && c < 0xe000)) c = 0xfffd;
    if (c < 0x20 || c == 0x7f) c = ' ';  // a name stays on its line
    if (c < 0x80) {
      add(c);
    } else if (c < 0x800) {
      add(0xc0 | c >> 6), add(0x80 | (c & 0x3f));
    } else if (c < 0x10000) {
      add(0xe0 | c >> 12), add(0x80 | (c >> 6 & 0x3f)), add(0x80 | (c & 0x3f));
    } else {
      add(0xf0 | c >> 18), add(0x80 | (c >> 12 & 0x3f));
      add(0x80 | (c >> 6 & 0x3f)), add(0x80 | (c & 0x3f));
    }
  }
  return out;
}

std::vector<HidInfo> Enumerate() {
  std::vector<HidInfo> list;
  hid_device_info* const first = hid_enumerate(0, 0);
  for (const hid_device_info* i = first; i != nullptr; i = i->next) {
    if (i->path == nullptr) continue;
    const auto same =
        std::find_if(list.begin(), list.end(), [i](const auto& d) { return d.path == i->path; });
    HidInfo& info = same != list.end() ? *same : list.emplace_back();
    info.path = i->path;
    info.vendor = i->vendor_id;
    info.product = i->product_id;
    info.maker = Utf8(i->manufacturer_string);
    info.name = Utf8(i->product_string);
    info.serial = Utf8(i->serial_number);
    info.usages.push_back({i->usage_page, i->usage});
  }
  hid_free_enumeration(first);
  return list;
}

bool IsListed(const std::string& path, const std::vector<HidInfo>& list) {
  return std::any_of(list.begin(), list.end(), [&](const auto& i) { return i.path == path; });
}

/// Empty for a node that is not listed.
std::string RuleFor(const std::string& path, const std::vector<HidInfo>& list) {
  for (const HidInfo& info : list) {
    if (info.path == path) return UdevRule({info.vendor, info.product, true});
  }
  return {};
}

/// hidapi 0.13.1 writes into freed memory when it opens a file that is no HID node: only nodes and
/// listed paths are passed on.
hid_device* OpenNode(const std::string& path) {
  const std::scoped_lock lock(HidapiMutex());
  const bool is_node = path.rfind("/dev/hidraw", 0) == 0;
  if (!is_node && !IsListed(path, Enumerate())) {
    throw DeviceError(fmt::format("{}: no HID device: \"moontrace devices\" lists them", path));
  }
  hid_device* const device = hid_open_path(path.c_str());
  if (device != nullptr) return device;
  const std::string why = Utf8(hid_error(nullptr));
  const bool refused = why.find("ermission denied") != std::string::npos ||
                       (access(path.c_str(), F_OK) == 0 && access(path.c_str(), R_OK | W_OK) != 0);
  if (refused) {
    throw PermissionError(
        fmt::format("{}: no permission: \"moontrace devices\" tells how to give it", path),
        RuleFor(path, Enumerate()));
  }
  throw DeviceError(fmt::format("{}: cannot be opened ({}): plug it in again", path,
                                why.empty() ? "no reason given" : why));
}

/// Where the kernel shows the descriptor to everyone. MOONTRACE_HIDRAW_SYSFS, for tests only, names
/// a folder that stands for /sys/class/hidraw.
std::string DescriptorFile(const std::string& path) {
  const char* const other = std::getenv("MOONTRACE_HIDRAW_SYSFS");
  const std::string folder = other != nullptr ? other : "/sys/class/hidraw";
  const std::string node = path.substr(path.find_last_of('/') + 1);
  return folder + "/" + node + "/device/report_descriptor";
}

std::vector<std::uint8_t> ReadDescriptorFile(const std::string& path) {
  std::ifstream file(DescriptorFile(path), std::ios::binary);
  std::vector<char> bytes(kMostDescriptor);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(file.gcount())};
}

hid_device* Native(void* handle) { return static_cast<hid_device*>(handle); }

}  // namespace

bool HidIsBuiltIn() { return true; }

std::vector<HidInfo> ListHid() {
  const std::scoped_lock lock(HidapiMutex());
  return Enumerate();
}

std::vector<std::uint8_t> ReportDescriptorOf(const std::string& path) {
  // The file first: it needs no permission and opens nothing.
  std::vector<std::uint8_t> bytes = ReadDescriptorFile(path);
#if HID_API_VERSION >= HID_API_MAKE_VERSION(0, 14, 0)
  if (bytes.empty()) {
    hid_device* const device = OpenNode(path);
    bytes.resize(kMostDescriptor);
    const int size = hid_get_report_descriptor(device, bytes.data(), bytes.size());
    bytes.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    hid_close(device);
  }
#endif
  if (bytes.empty()) {
    throw DeviceError(
        fmt::format("{}: its report descriptor cannot be read: plug it in again", path));
  }
  return bytes;
}

HidHandle HidHandle::Open(const std::string& path) { return HidHandle(OpenNode(path)); }

int HidHandle::Read(std::span<std::uint8_t> report, int milliseconds) noexcept {
  errno = 0;
  const int n = hid_read_timeout(Native(handle_.get()), report.data(), report.size(), milliseconds);
  return n < 0 && errno == EINTR ? 0 : n;
}

bool HidHandle::Write(std::span<const std::uint8_t> report) noexcept {
  return hid_write(Native(handle_.get()), report.data(), report.size()) >= 0;
}

int HidHandle::GetFeature(std::span<std::uint8_t> report) noexcept {
  return hid_get_feature_report(Native(handle_.get()), report.data(), report.size());
}

bool HidHandle::SendFeature(std::span<const std::uint8_t> report) noexcept {
  return hid_send_feature_report(Native(handle_.get()), report.data(), report.size()) >= 0;
}

void HidHandle::Closer::operator()(void* handle) const noexcept { hid_close(Native(handle)); }

#else  // without hidapi

bool HidIsBuiltIn() { return false; }
std::vector<HidInfo> ListHid() { return {}; }

namespace {
[[noreturn]] void Lack(const std::string& path) {
  throw DeviceError(fmt::format(
      "{}: this program was built without hidapi: install libhidapi-dev, build again", path));
}
}  // namespace

std::vector<std::uint8_t> ReportDescriptorOf(const std::string& path) { Lack(path); }
HidHandle HidHandle::Open(const std::string& path) { Lack(path); }
int HidHandle::Read(std::span<std::uint8_t>, int) noexcept { return -1; }
bool HidHandle::Write(std::span<const std::uint8_t>) noexcept { return false; }
int HidHandle::GetFeature(std::span<std::uint8_t>) noexcept { return -1; }
bool HidHandle::SendFeature(std::span<const std::uint8_t>) noexcept { return false; }
void HidHandle::Closer::operator()(void*) const noexcept {}

#endif

HidHandle::HidHandle(HidHandle&&) noexcept = default;
HidHandle& HidHandle::operator=(HidHandle&&) noexcept = default;
HidHandle::~HidHandle() = default;

}  // namespace moontrace
