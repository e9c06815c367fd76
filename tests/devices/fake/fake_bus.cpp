#include "tests/devices/fake/fake_bus.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <glm/vec3.hpp>

namespace moontrace::fake {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kQueue = 63;   // what the kernel keeps of unread reports: the oldest
constexpr double kReplugTime = 0.3;  // [s]

std::string Environment(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr ? value : "";
}

Fault ReadFault() {
  const std::string text = Environment("MOONTRACE_FAKE_FAULT");
  const std::size_t mark = text.find('@');
  if (mark == std::string::npos) return {text, 0};
  return {text.substr(0, mark), std::atof(text.c_str() + mark + 1) * 1e-3};
}

void WriteDescriptor(const Port& port, const std::string& folder) {
  namespace fs = std::filesystem;
  const fs::path place = fs::path(folder) / fs::path(port.path).filename() / "device";
  fs::create_directories(place);
  std::ofstream file(place / "report_descriptor", std::ios::binary);
  const auto& bytes = port.identity.descriptor;
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

void Plug(Port& port) {
  port.emulator = MakeEmulator(port.kind);
  port.identity = port.emulator->Describe();
  port.plugged = Now();
  port.is_gone = false;
  ++port.plugging;
}

}  // namespace

double Now() { return std::chrono::duration<double>(Clock::now().time_since_epoch()).count(); }

Bus& TheBus() {
  static Bus* const bus = new Bus;
  return *bus;
}

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
  const std::string log_path = is_owner ? Environment("MOONTRACE_FAKE_LOG") : "";
  log = log_path.empty() ? nullptr : std::fopen(log_path.c_str(), "w");
  std::string kinds = Environment("MOONTRACE_FAKE_HID");
  for (std::size_t begin = 0; begin < kinds.size();) {
    const std::size_t end = std::min(kinds.find(',', begin), kinds.size());
    auto port = std::make_unique<Port>();
    port->kind = kinds.substr(begin, end - begin);
    port->path = "/dev/hidraw-fake" + std::to_string(ports.size());
    const auto same = std::count_if(ports.begin(), ports.end(),
                                    [&](const auto& other) { return other->kind == port->kind; });
    port->name = port->kind;
    if (same > 0) port->name.append("-").append(std::to_string(same + 1));
    begin = end + 1;
    if (MakeEmulator(port->kind) == nullptr) {
      std::fprintf(stderr, "MOONTRACE_FAKE_HID: no kind '%s'\n", port->kind.c_str());
      std::abort();
    }
    Plug(*port);
    if (fault.kind == "wrong-descriptor") {
      port->identity.descriptor.resize(port->identity.descriptor.size() * 2 / 3);
    }
    if (is_owner) WriteDescriptor(*port, folder);
    ports.push_back(std::move(port));
  }
}

Port* Bus::At(const std::string& path) {
  for (const auto& port : ports) {
    if (port->path == path) return port.get();
  }
  return nullptr;
}

void Bus::Log(const Port& port, const char* what, Bytes bytes, double time) {
  if (log == nullptr) return;
  std::fprintf(log, "%.3f %s %s", (time - began) * 1e3, port.name.c_str(), what);
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
    std::fprintf(log, "%.3f %s force %.6f %.6f %.6f\n", (now - began) * 1e3, port.name.c_str(),
                 force.x, force.y, force.z);
    std::fflush(log);
  }
  port.force = force;
}

}  // namespace moontrace::fake
