#pragma once

#include <cstdio>
#include <deque>
#include <glm/vec3.hpp>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <vector>

#include "tests/devices/fake/emulator.h"

struct hid_device_;

namespace moontrace::fake {

using Report = std::vector<std::uint8_t>;

/// Steady clock [s].
double Now();

struct Fault {
  std::string kind;
  double at = 0;  // [s] after the first opening
};

/// One place where a device is plugged in.
struct Port {
  std::string kind, path;
  std::string name;  // in the log: the kind, then kind-2, kind-3
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
  bool is_owner = true;  // else devices are another process' and only their list is here

  void Build();
  Port* At(const std::string& path);
  /// A call that the host made at `time` on the clock [s].
  void Log(const Port& port, const char* what, Bytes bytes, double time);
  void Settle(Port& port);
  void Break(Port& port);
  void Deliver(Port& port, Bytes report);
};

/// The one there is.
Bus& TheBus();

}  // namespace moontrace::fake

/// hidapi's handle.
struct hid_device_ {
  moontrace::fake::Port* port = nullptr;
  int plugging = 0;
  std::deque<moontrace::fake::Report> queue;
  std::wstring error = L"Success";
  int connection = -1;  ///< to the owner of the bus, if that is another process
};
