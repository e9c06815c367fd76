#pragma once

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace moontrace {

/// Emulated HID devices for one test: plugs them in and reads what reached them. Needs the fake
/// hidapi (fake/fake_hidapi.cpp, where kinds and faults are listed) first in LD_LIBRARY_PATH, as
/// ctest sets it.
class FakeHid {
 public:
  explicit FakeHid(const std::string& kinds, const std::string& fault = "") {
    char name[] = "/tmp/moontrace-log-XXXXXX";
    const int file = mkstemp(name);
    EXPECT_GE(file, 0);
    if (file >= 0) close(file);
    log_ = name;
    setenv("MOONTRACE_FAKE_HID", kinds.c_str(), 1);
    setenv("MOONTRACE_FAKE_FAULT", fault.c_str(), 1);
    setenv("MOONTRACE_FAKE_LOG", log_.c_str(), 1);
    Reset();
  }
  ~FakeHid() {
    setenv("MOONTRACE_FAKE_HID", "", 1);
    setenv("MOONTRACE_FAKE_FAULT", "", 1);
    setenv("MOONTRACE_FAKE_LOG", "", 1);
    Reset();
    std::remove(log_.c_str());
  }
  FakeHid(const FakeHid&) = delete;
  FakeHid& operator=(const FakeHid&) = delete;

  /// When the log's time 0 was, steady clock [s].
  static double Began() {
    using Function = double (*)();
    const auto began = reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, "moontrace_fake_hid_began"));
    return began != nullptr ? began() : 0;
  }

  /// One line of the log.
  struct Line {
    double time = 0;  ///< [ms]
    std::string kind, what;
    std::vector<int> bytes;     ///< of out and set
    std::vector<double> force;  ///< of force [N]
  };
  std::vector<Line> Log() const {
    std::vector<Line> lines;
    std::ifstream file(log_);
    for (std::string text; std::getline(file, text);) {
      std::istringstream in(text);
      Line line;
      in >> line.time >> line.kind >> line.what;
      for (std::string word; in >> word;) {
        if (line.what == "force") {
          line.force.push_back(std::stod(word));
        } else {
          line.bytes.push_back(std::stoi(word, nullptr, 16));
        }
      }
      lines.push_back(line);
    }
    return lines;
  }
  /// Lines of one sort; `id` >= 0: only reports of this number.
  std::vector<Line> Log(const std::string& what, int id = -1) const {
    std::vector<Line> found;
    for (const Line& line : Log()) {
      if (line.what == what && (id < 0 || (!line.bytes.empty() && line.bytes[0] == id))) {
        found.push_back(line);
      }
    }
    return found;
  }

 private:
  static void Reset() {
    using Function = void (*)();
    const auto reset = reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, "moontrace_fake_hid_reset"));
    ASSERT_NE(reset, nullptr) << "the fake hidapi is not loaded: run this by ctest, or put the "
                                 "build's tests/fake_hidapi first in LD_LIBRARY_PATH";
    reset();
  }

  std::string log_;
};

}  // namespace moontrace
