// A stand-in for libhidapi-hidraw.so.0, of the same ABI (hidapi 0.13), with emulated devices. First
// in LD_LIBRARY_PATH it serves an unchanged program. Environment variables:
//   MOONTRACE_FAKE_HID    kinds that are plugged in, "pid" or "pid,moontrace-raw"
//   MOONTRACE_FAKE_FAULT  FAULT@MILLISECONDS after the first opening of a device; once:
//                         unplug, replug (back after 300 ms), deaf (writes and features take 5 s
//                         and fail), stuck (one report for ever), jump20 (20 mm aside), garbage
//                         (random reports), truncated (half reports), flood (endless reports),
//                         disabled (motors switched off); from the start: wrong-descriptor (two
//                         thirds of it), refused (no permission)
//   MOONTRACE_FAKE_LOG    a file that gets a line for every report the host sends and every change
//   of
//                         force: MILLISECONDS KIND out|set BYTES, or MILLISECONDS KIND force X Y Z
// Descriptors lie in a folder of its own, which it names in MOONTRACE_HIDRAW_SYSFS.
#include <hidapi.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <cwchar>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>

#include "tests/devices/fake/fake_bus.h"

namespace {

using moontrace::fake::Bus;
using moontrace::fake::Bytes;
using moontrace::fake::Identity;
using moontrace::fake::Now;
using moontrace::fake::Port;
using moontrace::fake::Report;
using moontrace::fake::TheBus;

constexpr double kDeafTime = 5;  // [s]

void Sleep(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

wchar_t* Wide(const std::string& text) {
  return wcsdup(std::wstring(text.begin(), text.end()).c_str());
}

/// What failed last in listing or opening; set and read under hidapi's own rule, one at a time.
std::wstring& GlobalError() {
  static std::wstring* const error = new std::wstring(L"Success");
  return *error;
}

bool IsDead(const hid_device_& handle) {
  return handle.port->is_gone || handle.plugging != handle.port->plugging;
}

/// What every call on a handle begins with; false: the device is gone. A deaf one takes its time.
bool Reach(hid_device_& handle, bool writes) {
  Bus& bus = TheBus();
  bool is_deaf = false;
  {
    const std::scoped_lock lock(bus.turn);
    bus.Settle(*handle.port);
    if (IsDead(handle)) {
      handle.error = L"No such device";
      return false;
    }
    is_deaf = writes && handle.port->has_faulted && bus.fault.kind == "deaf";
  }
  if (!is_deaf) return true;
  Sleep(kDeafTime);
  handle.error = L"Connection timed out";
  return false;
}

/// The folder of descriptors stands as long as the program.
struct Folder {
  Folder() {
    char name[] = "/tmp/moontrace-fake-XXXXXX";
    if (mkdtemp(name) == nullptr) std::abort();
    TheBus().folder = name;
    setenv("MOONTRACE_HIDRAW_SYSFS", name, 1);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(TheBus().folder, ignored);
  }
} const folder;

}  // namespace

extern "C" {

/// For tests in the same program: the environment is read again, everything is plugged in anew;
/// handles that are still open find their device gone.
__attribute__((visibility("default"))) void moontrace_fake_hid_reset() {
  const std::scoped_lock lock(TheBus().turn);
  TheBus().Build();
}

int hid_init() { return 0; }
int hid_exit() { return 0; }
const char* hid_version_str() { return "0.13.1-fake"; }

hid_device_info* hid_enumerate(unsigned short vendor, unsigned short product) {
  Bus& bus = TheBus();
  const std::scoped_lock lock(bus.turn);
  if (!bus.is_built) bus.Build();
  hid_device_info* first = nullptr;
  for (const auto& port : bus.ports) {
    bus.Settle(*port);
    const Identity& identity = port->identity;
    if (port->is_gone || (vendor != 0 && vendor != identity.vendor) ||
        (product != 0 && product != identity.product)) {
      continue;
    }
    for (const auto& [page, usage] : identity.usages) {
      auto* const info = static_cast<hid_device_info*>(std::calloc(1, sizeof(hid_device_info)));
      if (info == nullptr) std::abort();
      info->path = strdup(port->path.c_str());
      info->vendor_id = identity.vendor, info->product_id = identity.product;
      info->manufacturer_string = Wide(identity.maker);
      info->product_string = Wide(identity.name);
      info->serial_number = Wide(identity.serial);
      info->usage_page = page, info->usage = usage;
      info->interface_number = -1;
      info->next = first;
      first = info;
    }
  }
  return first;
}

void hid_free_enumeration(hid_device_info* info) {
  while (info != nullptr) {
    hid_device_info* const next = info->next;
    std::free(info->path), std::free(info->serial_number);
    std::free(info->manufacturer_string), std::free(info->product_string);
    std::free(info);
    info = next;
  }
}

hid_device* hid_open_path(const char* path) {
  Bus& bus = TheBus();
  const std::scoped_lock lock(bus.turn);
  if (!bus.is_built) bus.Build();
  Port* const port = bus.At(path);
  if (port != nullptr) bus.Settle(*port);
  if (port == nullptr || port->is_gone) {
    GlobalError() = L"No such file or directory";
    return nullptr;
  }
  if (bus.fault.kind == "refused") {
    GlobalError() = L"Permission denied";
    return nullptr;
  }
  if (port->opened < 0) port->opened = Now();
  auto* const handle = new hid_device_;
  handle->port = port;
  handle->plugging = port->plugging;
  port->handles.push_back(handle);
  return handle;
}

hid_device* hid_open(unsigned short, unsigned short, const wchar_t*) { return nullptr; }

void hid_close(hid_device* device) {
  if (device == nullptr) return;
  const std::scoped_lock lock(TheBus().turn);
  std::erase(device->port->handles, device);
  delete device;
}

const wchar_t* hid_error(hid_device* device) {
  return device != nullptr ? device->error.c_str() : GlobalError().c_str();
}

int hid_write(hid_device* device, const unsigned char* data, size_t length) {
  if (!Reach(*device, true)) return -1;
  Bus& bus = TheBus();
  const std::scoped_lock lock(bus.turn);
  Port& port = *device->port;
  bus.Log(port, "out", {data, length});
  port.emulator->Output({data, length}, Now() - port.plugged,
                        [&](Bytes report) { bus.Deliver(port, report); });
  return static_cast<int>(length);
}

int hid_read_timeout(hid_device* device, unsigned char* data, size_t length, int milliseconds) {
  const double end = Now() + milliseconds * 1e-3;
  for (;;) {
    if (!Reach(*device, false)) return -1;
    {
      const std::scoped_lock lock(TheBus().turn);
      if (!device->queue.empty()) {
        const Report report = std::move(device->queue.front());
        device->queue.pop_front();
        const std::size_t n = std::min(length, report.size());
        std::copy_n(report.begin(), n, data);
        return static_cast<int>(n);
      }
    }
    const double left = end - Now();
    if (milliseconds >= 0 && left <= 0) return 0;
    Sleep(milliseconds < 0 ? 5e-4 : std::min(5e-4, left));
  }
}

int hid_read(hid_device* device, unsigned char* data, size_t length) {
  return hid_read_timeout(device, data, length, -1);
}

int hid_set_nonblocking(hid_device*, int) { return -1; }

int hid_send_feature_report(hid_device* device, const unsigned char* data, size_t length) {
  if (!Reach(*device, true)) return -1;
  const std::scoped_lock lock(TheBus().turn);
  TheBus().Log(*device->port, "set", {data, length});
  return device->port->emulator->SetFeature({data, length}) ? static_cast<int>(length) : -1;
}

int hid_get_feature_report(hid_device* device, unsigned char* data, size_t length) {
  if (!Reach(*device, true)) return -1;
  const std::scoped_lock lock(TheBus().turn);
  return device->port->emulator->GetFeature({data, length});
}

int hid_get_report_descriptor(hid_device* device, unsigned char* data, size_t length) {
  if (!Reach(*device, false)) return -1;
  const std::vector<std::uint8_t>& bytes = device->port->identity.descriptor;
  const std::size_t n = std::min(length, bytes.size());
  std::copy_n(bytes.begin(), n, data);
  return static_cast<int>(n);
}

}  // extern "C"
