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
//                         force: MILLISECONDS KIND out|set BYTES, or MILLISECONDS KIND force X Y Z;
//                         a second one of a kind is KIND-2
// Descriptors lie in a folder of its own, which it names in MOONTRACE_HIDRAW_SYSFS. Processes that
// the program starts find its devices (bus_socket.h), as they would find the real ones.
#include <hidapi.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <cwchar>
#include <filesystem>
#include <mutex>
#include <span>
#include <string>
#include <thread>

#include "tests/devices/fake/bus_socket.h"
#include "tests/devices/fake/fake_bus.h"

namespace {

using moontrace::fake::Answer;
using moontrace::fake::Call;

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

/// A new handle, or null and the reason in GlobalError.
hid_device_* OpenHere(const char* path) {
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
  if (port->handles.empty()) port->emulator->Open();
  auto* const handle = new hid_device_;
  handle->port = port;
  handle->plugging = port->plugging;
  port->handles.push_back(handle);
  return handle;
}

/// `time`: when the host wrote.
int Write(hid_device_& handle, Bytes report, double time) {
  if (!Reach(handle, true)) return -1;
  Bus& bus = TheBus();
  const std::scoped_lock lock(bus.turn);
  Port& port = *handle.port;
  bus.Log(port, "out", report, time);
  port.emulator->Output(report, Now() - port.plugged,
                        [&](Bytes answer) { bus.Deliver(port, answer); });
  return static_cast<int>(report.size());
}

/// What is there already; 0 for nothing.
int ReadNow(hid_device_& handle, std::span<std::uint8_t> report) {
  if (!Reach(handle, false)) return -1;
  const std::scoped_lock lock(TheBus().turn);
  if (handle.queue.empty()) return 0;
  const Report first = std::move(handle.queue.front());
  handle.queue.pop_front();
  const std::size_t n = std::min(report.size(), first.size());
  std::copy_n(first.begin(), n, report.begin());
  return static_cast<int>(n);
}

int SendFeature(hid_device_& handle, Bytes report, double time) {
  if (!Reach(handle, true)) return -1;
  const std::scoped_lock lock(TheBus().turn);
  TheBus().Log(*handle.port, "set", report, time);
  return handle.port->emulator->SetFeature(report) ? static_cast<int>(report.size()) : -1;
}

int GetFeature(hid_device_& handle, std::span<std::uint8_t> report) {
  if (!Reach(handle, true)) return -1;
  const std::scoped_lock lock(TheBus().turn);
  return handle.port->emulator->GetFeature(report);
}

/// The owner: what another process asks of one handle.
void Serve(void*& kept, const Call& call, Answer& answer) {
  auto* handle = static_cast<hid_device_*>(kept);
  const auto size = std::min(static_cast<std::size_t>(std::max(call.size, 0)), sizeof call.data);
  const Bytes bytes(call.data, size);
  const std::span<std::uint8_t> room(answer.data, size);
  if (call.what == Call::kOpen) {
    kept = handle = OpenHere(reinterpret_cast<const char*>(call.data));
    answer.result = handle != nullptr ? 0 : -1;
  }
  if (handle == nullptr) return;
  if (call.what == Call::kWrite) answer.result = Write(*handle, bytes, call.time);
  if (call.what == Call::kRead) answer.result = ReadNow(*handle, room);
  if (call.what == Call::kSendFeature) answer.result = SendFeature(*handle, bytes, call.time);
  if (call.what == Call::kGetFeature) {
    std::copy(bytes.begin(), bytes.end(), room.begin());
    answer.result = GetFeature(*handle, room);
  }
}

void Hang(void* handle) { hid_close(static_cast<hid_device_*>(handle)); }

/// Children find the devices from the first opening on.
void ServeOnce() {
  static const bool serves = [] {
    const std::string path = TheBus().folder + "/bus";
    moontrace::fake::ServeBus(path, Serve, Hang);
    setenv(moontrace::fake::kBusVariable, path.c_str(), 1);
    return true;
  }();
  static_cast<void>(serves);
}

/// Another process' device: the call with `data`, the answer into `room` if there is one.
int Ask(hid_device_& handle, Call::What what, const unsigned char* data, std::size_t length,
        unsigned char* room) {
  Call call;
  Answer answer;
  call.what = what;
  call.time = Now();
  const std::size_t size = std::min(length, sizeof call.data);
  call.size = static_cast<std::int32_t>(size);
  if (data != nullptr) std::copy_n(data, size, call.data);
  if (!moontrace::fake::CallBus(handle.connection, call, answer)) return -1;
  if (answer.result < 0) handle.error = L"No such device";
  if (room != nullptr && answer.result > 0) {
    std::copy_n(answer.data, static_cast<std::size_t>(answer.result), room);
  }
  return answer.result;
}

/// The folder of descriptors stands as long as the program.
struct Folder {
  Folder() {
    if (std::getenv(moontrace::fake::kBusVariable) != nullptr) {
      TheBus().is_owner = false;
      return;
    }
    char name[] = "/tmp/moontrace-fake-XXXXXX";
    if (mkdtemp(name) == nullptr) std::abort();
    TheBus().folder = name;
    setenv("MOONTRACE_HIDRAW_SYSFS", name, 1);
  }
  ~Folder() {
    std::error_code ignored;
    if (TheBus().is_owner) std::filesystem::remove_all(TheBus().folder, ignored);
  }
} const folder;

}  // namespace

extern "C" {

/// For tests in the same program: the environment is read again, everything is plugged in anew;
/// handles that are still open find their device gone.
__attribute__((visibility("default"))) void moontrace_fake_hid_reset() {
  if (TheBus().is_owner) ServeOnce();
  const std::scoped_lock lock(TheBus().turn);
  TheBus().Build();
}

/// When the log's time 0 was, steady clock [s].
__attribute__((visibility("default"))) double moontrace_fake_hid_began() {
  const std::scoped_lock lock(TheBus().turn);
  return TheBus().began;
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
  if (bus.is_owner) {
    ServeOnce();
    return OpenHere(path);
  }
  const int connection = moontrace::fake::ConnectToBus(std::getenv(moontrace::fake::kBusVariable));
  if (connection < 0) return nullptr;
  auto* const handle = new hid_device_;
  handle->connection = connection;
  const auto* const bytes = reinterpret_cast<const unsigned char*>(path);
  if (Ask(*handle, Call::kOpen, bytes, std::strlen(path) + 1, nullptr) >= 0) return handle;
  GlobalError() = L"No such file or directory";
  hid_close(handle);
  return nullptr;
}

hid_device* hid_open(unsigned short, unsigned short, const wchar_t*) { return nullptr; }

void hid_close(hid_device* device) {
  if (device == nullptr) return;
  if (device->connection >= 0) {
    close(device->connection);
    delete device;
    return;
  }
  const std::scoped_lock lock(TheBus().turn);
  std::erase(device->port->handles, device);
  delete device;
}

const wchar_t* hid_error(hid_device* device) {
  return device != nullptr ? device->error.c_str() : GlobalError().c_str();
}

int hid_write(hid_device* device, const unsigned char* data, size_t length) {
  if (device->connection >= 0) return Ask(*device, Call::kWrite, data, length, nullptr);
  return Write(*device, {data, length}, Now());
}

int hid_read_timeout(hid_device* device, unsigned char* data, size_t length, int milliseconds) {
  const double end = Now() + milliseconds * 1e-3;
  for (;;) {
    const int n = device->connection >= 0 ? Ask(*device, Call::kRead, nullptr, length, data)
                                          : ReadNow(*device, {data, length});
    if (n != 0) return n;
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
  if (device->connection >= 0) return Ask(*device, Call::kSendFeature, data, length, nullptr);
  return SendFeature(*device, {data, length}, Now());
}

int hid_get_feature_report(hid_device* device, unsigned char* data, size_t length) {
  if (device->connection >= 0) return Ask(*device, Call::kGetFeature, data, length, data);
  return GetFeature(*device, {data, length});
}

int hid_get_report_descriptor(hid_device* device, unsigned char* data, size_t length) {
  if (device->connection >= 0 || !Reach(*device, false)) return -1;
  const std::vector<std::uint8_t>& bytes = device->port->identity.descriptor;
  const std::size_t n = std::min(length, bytes.size());
  std::copy_n(bytes.begin(), n, data);
  return static_cast<int>(n);
}

}  // extern "C"
