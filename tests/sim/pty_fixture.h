#pragma once

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include "sim/app/cli.h"
#include "tests/signal_child.h"

namespace moontrace {

/// Whether a process gets pseudo-terminals here; none does where /dev/pts is missing, as in a bare
/// chroot.
inline bool HasTerminals() {
  int master = -1, slave = -1;
  if (openpty(&master, &slave, nullptr, nullptr, nullptr) != 0) return false;
  close(master);
  close(slave);
  return true;
}

#define SKIP_WITHOUT_TERMINALS() \
  if (!HasTerminals()) GTEST_SKIP() << "no pseudo-terminals here: /dev/pts is missing"

/// Waits until every other thread of this process waits. A fork at a moment when one of them is
/// within malloc leaves that locked in the child, where a sanitizer's allocator never opens it.
inline void AwaitOtherThreadsAtRest() {
  const auto at_rest = [] {
    const std::string own = std::to_string(gettid());
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
      if (task.path().filename() == own) continue;
      std::ifstream file(task.path() / "stat");
      std::string stat;
      std::getline(file, stat);  // "number (name) state ..."
      const std::size_t name = stat.rfind(") ");
      if (name != std::string::npos && stat.substr(name + 2, 1) != "S") return false;
    }
    return true;
  };
  for (int times = 0, tries = 0; times < 3 && tries < 1000; ++tries) {
    times = at_rest() ? times + 1 : 0;  // three times in a row, since one may be between two waits
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// A command line that runs in a process of its own at a pseudo-terminal, as a person's does.
class PtySession {
 public:
  explicit PtySession(const std::vector<std::string>& args, unsigned short columns = 80) {
    const winsize size{24, columns, 0, 0};
    EXPECT_EQ(openpty(&master_, &slave_, nullptr, nullptr, &size), 0);
    tcgetattr(slave_, &usual_);
    std::cout.flush();  // or the child would write it again
    AwaitOtherThreadsAtRest();
    child_ = fork();
    if (child_ != 0) return;
    setsid();
    for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(slave_, fd);
    close(master_);
    close(slave_);
    Console console(std::cin, std::cout, std::cerr);
    console.SetColumns([] { return TerminalColumns(STDOUT_FILENO); },
                       [] { return TerminalColumns(STDERR_FILENO); });
    const int code = RunCli(args, console);
    std::cout.flush();
    _exit(code);
  }
  ~PtySession() {
    if (child_ > 0) Kill(SIGKILL);
    close(master_);
    close(slave_);
  }
  PtySession(const PtySession&) = delete;
  PtySession& operator=(const PtySession&) = delete;

  void Send(const std::string& bytes) {
    EXPECT_EQ(write(master_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  /// Reads on until `text` has come, after what earlier waits have found. False: it did not within
  /// 30 s, or the process has ended.
  bool WaitFor(const std::string& text) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    for (;;) {
      const std::size_t at = all_.find(text, found_);
      if (at != std::string::npos) {
        found_ = at + text.size();
        return true;
      }
      if (std::chrono::steady_clock::now() > end || !Read(200)) return false;
    }
  }
  /// Sends a line and waits for a line of answer behind its echo. What is still being said is read
  /// before: the terminal would write the echo into its midst.
  bool Ask(const std::string& line) {
    do {
      found_ = all_.size();
      Read(40);  // twice as long as the program waits for a line before it looks around
    } while (all_.size() != found_);
    Send(line + "\n");
    return WaitFor(line) && WaitFor("\r\n") && WaitFor("\r\n");
  }
  /// Reads what comes within so many milliseconds, or to the end.
  void ReadFor(int milliseconds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(milliseconds);
    while (std::chrono::steady_clock::now() < end && Read(10)) {
    }
  }
  /// The exit code, once it has ended by itself.
  int Wait() {
    while (!Ended()) Read(20);
    while (Read(20)) {  // more than one block may be left
    }
    return status_;
  }
  /// Ends it by a signal, and reads what it still said.
  void Kill(int signal_number) {
    SignalChild(child_, signal_number);
    int status = 0;
    waitpid(child_, &status, 0);
    child_ = -1;
    while (Read(20)) {
    }
  }
  const std::string& all() const { return all_; }
  /// The terminal is as it was before the process began.
  bool terminal_is_usual() const {
    termios now{};
    tcgetattr(slave_, &now);
    return now.c_lflag == usual_.c_lflag && now.c_iflag == usual_.c_iflag &&
           now.c_oflag == usual_.c_oflag;
  }
  bool echoes() const {
    termios now{};
    tcgetattr(slave_, &now);
    return (now.c_lflag & ECHO) != 0;
  }

 private:
  bool Ended() {
    if (child_ < 0) return true;
    int status = 0;
    if (waitpid(child_, &status, WNOHANG) != child_) return false;
    child_ = -1;
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return true;
  }
  /// False: nothing came, and the process has ended.
  bool Read(int milliseconds) {
    pollfd wait{master_, POLLIN, 0};
    if (poll(&wait, 1, milliseconds) <= 0) return child_ > 0 && !Ended();
    char block[4096];
    const ssize_t count = read(master_, block, sizeof block);
    if (count <= 0) return false;
    all_.append(block, static_cast<std::size_t>(count));
    return true;
  }

  int master_ = -1, slave_ = -1;
  pid_t child_ = -1;
  int status_ = -1;
  termios usual_{};
  std::string all_;
  std::size_t found_ = 0;
};

/// What a screen reader and a Braille display can follow: no escape byte, no carriage return but
/// the terminal's own before a line feed, no line over 80 columns.
inline void ExpectStream(const std::string& all) {
  std::size_t column = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto byte = static_cast<unsigned char>(all[i]);
    EXPECT_NE(byte, 0x1b) << "an escape byte at " << i;
    if (byte == '\r') {
      // echoing "\r\n" twice is the terminal's doing too
      EXPECT_TRUE(i + 1 < all.size() && all[i + 1] == '\n') << "a carriage return at " << i;
      continue;
    }
    EXPECT_TRUE(byte >= 0x20 || byte == '\n') << "control byte " << int{byte} << " at " << i;
    if (byte == '\n') {
      column = 0;
    } else if ((byte & 0xc0) != 0x80) {
      EXPECT_LE(++column, 80U) << all.substr(i - 80, 81);
    }
  }
}

}  // namespace moontrace
