#include "sim/learn/raw_terminal.h"

#include <termios.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>

#include "sim/learn/learn_messages.h"
#include "textures/base/error.h"

namespace moontrace {

namespace {

/// What a handler needs: set before it is installed. tcsetattr may be called within one.
termios usual;
termios raw;
std::atomic<int> ends{0};  ///< signals that asked for an end so far
static_assert(std::atomic<int>::is_always_lock_free, "set within a signal handler");

constexpr std::array kEnds = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};
constexpr std::array kCrashes = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
std::array<struct sigaction, kEnds.size()> before_ends;
std::array<struct sigaction, kCrashes.size()> before_crashes;
struct sigaction before_stop, before_go_on;

void DieOf(int number) {
  tcsetattr(STDIN_FILENO, TCSANOW, &usual);
  std::signal(number, SIG_DFL);
  std::raise(number);
}

/// The first asks the program to end, as it would without us; a second one ends it at once.
extern "C" void EndTerminal(int number) {
  if (ends.fetch_add(1) > 0) return DieOf(number);
  for (std::size_t i = 0; i < kEnds.size(); ++i) {
    const struct sigaction& was = before_ends[i];
    if (kEnds[i] != number) continue;
    if (was.sa_handler == SIG_IGN) {
      ends.store(0);
    } else if (was.sa_handler == SIG_DFL) {
      DieOf(number);
    } else {
      was.sa_handler(number);
    }
  }
}

extern "C" void CrashTerminal(int number) { DieOf(number); }

/// Ctrl-Z: the shell gets its terminal as it was.
extern "C" void StopTerminal(int) {
  const int saved = errno;
  tcsetattr(STDIN_FILENO, TCSANOW, &usual);
  std::raise(SIGSTOP);
  errno = saved;
}

extern "C" void GoOnTerminal(int) {
  const int saved = errno;
  tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  errno = saved;
}

void Install(int number, void (*handler)(int), struct sigaction* before) {
  struct sigaction action = {};
  action.sa_handler = handler;  // no SA_RESTART: a wait for a key ends
  sigaction(number, &action, before);
}

}  // namespace

RawTerminal::RawTerminal() {
  if (tcgetattr(STDIN_FILENO, &usual) != 0) throw LackError(say::KeysNeedTerminal());
  raw = usual;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  raw.c_cc[VMIN] = 1;
  raw.c_cc[VTIME] = 0;
  ends.store(0);
  for (std::size_t i = 0; i < kEnds.size(); ++i) Install(kEnds[i], EndTerminal, &before_ends[i]);
  for (std::size_t i = 0; i < kCrashes.size(); ++i) {
    Install(kCrashes[i], CrashTerminal, &before_crashes[i]);
  }
  Install(SIGTSTP, StopTerminal, &before_stop);
  Install(SIGCONT, GoOnTerminal, &before_go_on);
  tcsetattr(STDIN_FILENO, TCSANOW, &raw);
}

RawTerminal::~RawTerminal() {
  tcsetattr(STDIN_FILENO, TCSANOW, &usual);
  for (std::size_t i = 0; i < kEnds.size(); ++i) sigaction(kEnds[i], &before_ends[i], nullptr);
  for (std::size_t i = 0; i < kCrashes.size(); ++i) {
    sigaction(kCrashes[i], &before_crashes[i], nullptr);
  }
  sigaction(SIGTSTP, &before_stop, nullptr);
  sigaction(SIGCONT, &before_go_on, nullptr);
}

}  // namespace moontrace
