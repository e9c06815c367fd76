// uhid_device KIND: one of the emulated devices (tests/devices/fake) plugged into the running
// kernel through /dev/uhid, until a signal ends it. Prints a line for every report the host sends
// and every change of force, as the fake hidapi's log does; the first line tells when its time 0
// was on the steady clock [ms].
#include <fcntl.h>
#include <linux/input.h>
#include <linux/uhid.h>
#include <poll.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <glm/vec3.hpp>
#include <memory>

#include "tests/devices/fake/emulator.h"

namespace {

using moontrace::fake::Bytes;
using moontrace::fake::Emulator;

double Now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

class Plug {
 public:
  Plug(int file, Emulator& emulator) : file_(file), emulator_(emulator), began_(Now()) {
    std::printf("%.3f began\n", began_ * 1e3);
  }

  bool Create() {
    const moontrace::fake::Identity identity = emulator_.Describe();
    uhid_event event{};
    event.type = UHID_CREATE2;
    uhid_create2_req& request = event.u.create2;
    identity.name.copy(reinterpret_cast<char*>(request.name), sizeof request.name - 1);
    identity.serial.copy(reinterpret_cast<char*>(request.uniq), sizeof request.uniq - 1);
    if (identity.descriptor.size() > sizeof request.rd_data) return false;
    request.rd_size = static_cast<__u16>(identity.descriptor.size());
    std::copy(identity.descriptor.begin(), identity.descriptor.end(), request.rd_data);
    request.bus = BUS_USB;
    request.vendor = identity.vendor;
    request.product = identity.product;
    return Put(event);
  }

  /// One round of a millisecond. False: the kernel is done with us.
  bool Serve() {
    pollfd wait{file_, POLLIN, 0};
    // Only the first look waits: a host that writes all the time must not stop the hand.
    for (int timeout = 1; poll(&wait, 1, timeout) > 0; timeout = 0) {
      uhid_event event{};
      if (read(file_, &event, sizeof event) < 0) return errno == EINTR;
      Answer(event);
    }
    const auto send = [this](Bytes report) { Input(report); };
    emulator_.Advance(Now() - began_, send);
    const glm::dvec3 force = emulator_.Force();
    if (force != force_) {
      std::printf("%.3f force %.6f %.6f %.6f\n", Milliseconds(), force.x, force.y, force.z);
    }
    force_ = force;
    return true;
  }

 private:
  double Milliseconds() const { return (Now() - began_) * 1e3; }

  bool Put(const uhid_event& event) {
    return write(file_, &event, sizeof event) == static_cast<ssize_t>(sizeof event);
  }

  void Print(const char* what, Bytes bytes) const {
    std::printf("%.3f %s", Milliseconds(), what);
    for (const auto byte : bytes) std::printf(" %02x", byte);
    std::printf("\n");
  }

  void Input(Bytes report) {
    uhid_event event{};
    event.type = UHID_INPUT2;
    event.u.input2.size = static_cast<__u16>(report.size());
    std::copy(report.begin(), report.end(), event.u.input2.data);
    Put(event);
  }

  void Answer(const uhid_event& event) {
    const auto send = [this](Bytes report) { Input(report); };
    uhid_event reply{};
    if (event.type == UHID_OUTPUT) {
      const Bytes report(event.u.output.data, event.u.output.size);
      Print("out", report);
      emulator_.Output(report, Now() - began_, send);
    } else if (event.type == UHID_SET_REPORT) {
      const Bytes report(event.u.set_report.data, event.u.set_report.size);
      Print("set", report);
      reply.type = UHID_SET_REPORT_REPLY;
      reply.u.set_report_reply.id = event.u.set_report.id;
      reply.u.set_report_reply.err = emulator_.SetFeature(report) ? 0 : EIO;
      Put(reply);
    } else if (event.type == UHID_GET_REPORT) {
      reply.type = UHID_GET_REPORT_REPLY;
      auto& answer = reply.u.get_report_reply;
      answer.id = event.u.get_report.id;
      answer.data[0] = event.u.get_report.rnum;
      const int n = emulator_.GetFeature(answer.data);
      answer.err = n < 0 ? EIO : 0;
      answer.size = static_cast<__u16>(std::max(n, 0));
      Put(reply);
    }
  }

  int file_;
  Emulator& emulator_;
  double began_;
  glm::dvec3 force_{0, 0, 0};
};

}  // namespace

int main(int argc, char** argv) {
  const auto emulator = argc == 2 ? moontrace::fake::MakeEmulator(argv[1]) : nullptr;
  if (emulator == nullptr) {
    std::fprintf(stderr, "usage: uhid_device KIND; kinds are in tests/devices/fake/emulator.cpp\n");
    return 2;
  }
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  sched_param priority{};
  priority.sched_priority = 46;  // hardware waits for nobody
  sched_setscheduler(0, SCHED_FIFO, &priority);
  const int file = open("/dev/uhid", O_RDWR | O_CLOEXEC);
  if (file < 0) {
    std::perror("/dev/uhid");
    return 1;
  }
  Plug plug(file, *emulator);
  if (!plug.Create()) {
    std::perror("uhid refuses the device");
    return 1;
  }
  while (plug.Serve()) {
  }
  return 0;  // closing the file unplugs it
}
