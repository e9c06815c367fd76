#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/signal_child.h"
#include "tests/sim/eventually.h"

namespace moontrace {

inline bool IsInstalled(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access((folder + "/" + program).c_str(), X_OK) == 0) return true;
  }
  return false;
}

/// A display of its own, without a screen: Xvfb. DISPLAY names it as long as it lives.
class TestDisplay {
 public:
  TestDisplay() {
    int pipe_fds[2] = {-1, -1};
    if (pipe(pipe_fds) != 0) return;
    child_ = fork();
    if (child_ == 0) {
      const std::string fd = std::to_string(pipe_fds[1]);
      const int nothing = open("/dev/null", O_RDWR);
      dup2(nothing, 1);
      dup2(nothing, 2);
      execlp("Xvfb", "Xvfb", "-displayfd", fd.c_str(), "-screen", "0", "1400x900x24", "-nolisten",
             "tcp", static_cast<char*>(nullptr));
      _exit(127);
    }
    close(pipe_fds[1]);
    for (char c = 0; read(pipe_fds[0], &c, 1) == 1 && c != '\n';) number_ += c;
    close(pipe_fds[0]);
    if (!number_.empty()) setenv("DISPLAY", (":" + number_).c_str(), 1);
  }
  ~TestDisplay() { Kill(); }
  TestDisplay(const TestDisplay&) = delete;
  TestDisplay& operator=(const TestDisplay&) = delete;

  bool runs() const { return child_ > 0 && !number_.empty(); }
  void Kill() {
    if (child_ <= 0) return;
    SignalChild(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
    child_ = -1;
    unlink(("/tmp/.X" + number_ + "-lock").c_str());
    unlink(("/tmp/.X11-unix/X" + number_).c_str());
    unsetenv("DISPLAY");
  }

  /// Runs xdotool with these words; whether it went well.
  bool Do(const std::vector<std::string>& words) const {
    std::vector<char*> arguments;
    std::string program = "xdotool";
    arguments.push_back(program.data());
    std::vector<std::string> copies = words;
    for (std::string& word : copies) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const pid_t tool = fork();
    if (tool == 0) {
      execvp("xdotool", arguments.data());
      _exit(127);
    }
    int status = 1;
    waitpid(tool, &status, 0);
    return status == 0;
  }
  bool MoveTo(int x, int y) const {
    return Do({"mousemove", std::to_string(x), std::to_string(y)});
  }
  bool Click(int x, int y) const {
    return Do({"mousemove", std::to_string(x), std::to_string(y), "click", "1"});
  }

 private:
  pid_t child_ = -1;
  std::string number_;
};

}  // namespace moontrace
