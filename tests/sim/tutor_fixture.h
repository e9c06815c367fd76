#pragma once

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>

#include "sim/console/line_buffer.h"
#include "sim/tutor/tutor_socket.h"
#include "tests/sim/eventually.h"

namespace moontrace {

/// The other end of a tutor's socket, by hand.
class RawTutor {
 public:
  explicit RawTutor(const std::string& path) : fd_(ConnectTo(path)) {}
  bool connected() const { return fd_.get() >= 0; }
  void Send(const std::string& bytes) {
    std::size_t sent = 0;
    while (sent < bytes.size() && Wait(POLLOUT)) {
      const ssize_t count =
          send(fd_.get(), bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
      if (count <= 0) return;
      sent += static_cast<std::size_t>(count);
    }
  }
  /// The next line; "(closed)" behind the last, "(silence)" after 10 s.
  std::string Line() {
    while (true) {
      if (const auto line = in_.Next()) return *line;
      if (!Wait(POLLIN)) return "(silence)";
      char block[4096];
      const ssize_t count = recv(fd_.get(), block, sizeof block, MSG_DONTWAIT);
      if (count <= 0) return "(closed)";
      in_.Feed({block, static_cast<std::size_t>(count)});
    }
  }
  void Leave() { fd_.Close(); }

 private:
  bool Wait(short events) const {
    pollfd polled{fd_.get(), events, 0};
    return poll(&polled, 1, 10000) > 0;
  }
  FileDescriptor fd_;
  LineBuffer in_{std::size_t{1} << 20U};
};

/// A runtime folder of the test's own: sockets' paths are short, so it is below /tmp.
class TutorRuntime {
 protected:
  TutorRuntime() {
    char name[] = "/tmp/moontrace-test-XXXXXX";
    runtime_ = mkdtemp(name);
    const char* before = std::getenv("XDG_RUNTIME_DIR");
    if (before != nullptr) before_ = before;
    setenv("XDG_RUNTIME_DIR", runtime_.c_str(), 1);
  }
  ~TutorRuntime() {
    if (before_.empty()) {
      unsetenv("XDG_RUNTIME_DIR");
    } else {
      setenv("XDG_RUNTIME_DIR", before_.c_str(), 1);
    }
    std::filesystem::remove_all(runtime_);
  }
  std::string folder() const { return runtime_ + "/moontrace"; }

  std::string runtime_, before_;
};

class TutorTest : public testing::Test, protected TutorRuntime {};

}  // namespace moontrace
