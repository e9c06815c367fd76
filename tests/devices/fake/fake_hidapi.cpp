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
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <cwchar>
#include <deque>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "tests/devices/fake/emulator.h"

namespace {

using moontrace::fake::Bytes;
using moontrace::fake::Emulator;
using moontrace::fake::Identity;
using Report = std::vector<std::uint8_t>;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kQueue = 63;  // what the kernel keeps of unread reports: the oldest
constexpr double kReplugTime = 0.3, kDeafTime = 5;  // [s]

double Now() { return std::chrono::duration<double>(Clock::now().time_since_epoch()).count(); }

std::string Environment(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr ? value : "";
}

void Sleep(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

struct Fault {
  std::string kind;
  double at = 0;  // [s] after the first opening
};

Fault ReadFault() {
  const std::string text = Environment("MOONTRACE_FAKE_FAULT");
  const std::size_t mark = text.find('@');
  if (mark == std::string::npos) return {text, 0};
  return {text.substr(0, mark), std::atof(text.c_str() + mark + 1) * 1e-3};
}

/// One place where a device is plugged in.
struct Port {
  std::string kind, path;
  std::unique_ptr<Emulator> emulator;
  Identity identity;
  double plugged = 0;  // [s] on the clock
  double opened = -1;  // first opening; < 0: not yet
  int plugging = 0;    // handles of an earlier one are dead
  bool is_gone = false;
  bool has_faulted = false;
  Report last;  // newest input report
  std::mt19937 random{1};
  glm::dvec3 force{0, 0, 0};
  std::vector<hid_device_*> handles;
};

void WriteDescriptor(const Port& port, const std::string& folder) {
  namespace fs = std::filesystem;
  const fs::path place = fs::path(folder) / fs::path(port.path).filename() / "device";
  fs::create_directories(place);
  std::ofstream file(place / "report_descriptor", std::ios::binary);
  const auto& bytes = port.identity.descriptor;
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

/// All ports, made anew from the environment by moontrace_fake_hid_reset. Never freed: threads that
/// wait in a deaf write may outlive main.
struct Bus {
  std::mutex turn;
  std::vector<std::unique_ptr<Port>> ports;
  std::vector<std::unique_ptr<Port>> scrapped;  // of before a reset: a handle may still be open
  Fault fault;
  std::string folder;
  std::FILE* log = nullptr;
  double began = 0;
  bool is_built = false;

  void Build();
  Port* At(const std::string& path);
  void Log(const Port& port, const char* what, Bytes bytes);
  void Settle(Port& port);
  void Break(Port& port);
  void Deliver(Port& port, Bytes report);
};

Bus& TheBus() {
  static Bus* const bus = new Bus;
  return *bus;
}

void Plug(Port& port) {
  port.emulator = moontrace::fake::MakeEmulator(port.kind);
  port.identity = port.emulator->Describe();
  port.plugged = Now();
  port.is_gone = false;
  ++port.plugging;
}

}  // namespace

struct hid_device_ {
  Port* port = nullptr;
  int plugging = 0;
  std::deque<Report> queue;
  std::wstring error = L"Success";
};

namespace {

void Bus::Build() {
  for (auto& port : ports) {
    port->is_gone = true;
    scrapped.push_back(std::move(port));
  }
  ports.clear();
  is_built = true;
  began = Now();
  fault = ReadFault();
  if (log != nullptr) std::fclose(log);
  const std::string log_path = Environment("MOONTRACE_FAKE_LOG");
  log = log_path.empty() ? nullptr : std::fopen(log_path.c_str(), "w");
  std::string kinds = Environment("MOONTRACE_FAKE_HID");
  for (std::size_t begin = 0; begin < kinds.size();) {
    const std::size_t end = std::min(kinds.find(',', begin), kinds.size());
    auto port = std::make_unique<Port>();
    port->kind = kinds.substr(begin, end - begin);
    port->path = "/dev/hidraw-fake" + std::to_string(ports.size());
    begin = end + 1;
    if (moontrace::fake::MakeEmulator(port->kind) == nullptr) {
      std::fprintf(stderr, "MOONTRACE_FAKE_HID: no kind '%s'\n", port->kind.c_str());
      std::abort();
    }
    Plug(*port);
    if (fault.kind == "wrong-descriptor") {
      port->identity.descriptor.resize(port->identity.descriptor.size() * 2 / 3);
    }
    WriteDescriptor(*port, folder);
    ports.push_back(std::move(port));
  }
}

Port* Bus::At(const std::string& path) {
  for (const auto& port : ports) {
    if (port->path == path) return port.get();
  }
  return nullptr;
}

void Bus::Log(const Port& port, const char* what, Bytes bytes) {
  if (log == nullptr) return;
  std::fprintf(log, "%.3f %s %s", (Now() - began) * 1e3, port.kind.c_str(), what);
  for (const std::uint8_t byte : bytes) std::fprintf(log, " %02x", byte);
  std::fputc('\n', log);
  std::fflush(log);
}

/// A report on its way to every open handle, as the fault would have it.
void Bus::Deliver(Port& port, Bytes report) {
  Report bytes(report.begin(), report.end());
  const bool faulty = port.has_faulted;
  if (faulty && fault.kind == "stuck" && !port.last.empty()) bytes = port.last;
  if (!faulty || fault.kind != "stuck") port.last = bytes;
  if (faulty && fault.kind == "truncated") bytes.resize((bytes.size() + 1) / 2);
  if (faulty && fault.kind == "garbage") {
    bytes.resize(1 + port.random() % 64);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(port.random());
  }
  const int copies = faulty && fault.kind == "flood" ? static_cast<int>(kQueue) : 1;
  for (hid_device_* handle : port.handles) {
    if (handle->plugging != port.plugging) continue;
    for (int i = 0; i < copies && handle->queue.size() < kQueue; ++i) {
      handle->queue.push_back(bytes);
    }
  }
}

/// The moment of the fault.
void Bus::Break(Port& port) {
  port.has_faulted = true;
  if (fault.kind == "unplug" || fault.kind == "replug") port.is_gone = true;
  if (fault.kind == "jump20") port.emulator->Jump(0.02);
  if (fault.kind == "disabled") port.emulator->Disable();
}

/// Brings a port up to now.
void Bus::Settle(Port& port) {
  const double now = Now();
  if (!port.has_faulted && !fault.kind.empty() && port.opened >= 0 &&
      now - port.opened >= fault.at) {
    Break(port);
  }
  if (port.is_gone) {
    if (At(port.path) != &port) return;  // scrapped
    if (fault.kind == "replug" && now - port.opened >= fault.at + kReplugTime) Plug(port);
    return;
  }
  port.emulator->Advance(now - port.plugged, [&](Bytes report) { Deliver(port, report); });
  const glm::dvec3 force = port.emulator->Force();
  if (log != nullptr && force != port.force) {
    std::fprintf(log, "%.3f %s force %.6f %.6f %.6f\n", (now - began) * 1e3, port.kind.c_str(),
                 force.x, force.y, force.z);
    std::fflush(log);
  }
  port.force = force;
}

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
