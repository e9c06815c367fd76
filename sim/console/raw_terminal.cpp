#include "sim/console/raw_terminal.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <string>
#include <utility>

#include "sim/console/word_messages.h"
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

/// As `stty -g` prints them and stty takes them.
std::string SttyForm(const termios& modes) {
  std::string form = fmt::format("{:x}:{:x}:{:x}:{:x}", modes.c_iflag, modes.c_oflag, modes.c_cflag,
                                 modes.c_lflag);
  for (const cc_t value : modes.c_cc) form += fmt::format(":{:x}", value);
  return form;
}

/// A process of its own that waits for this one's end and gives the terminal back, unless it was
/// told that all is well, or somebody else has changed the terminal since. A shell, since a fork
/// would make the tick copy its pages.
class Keeper {
 public:
  /// Where none can be started, the terminal is given back on all ways out but a kill.
  void Start() {
    int ends_of_pipe[2];
    if (pipe2(ends_of_pipe, O_CLOEXEC) != 0) return;
    const std::string script = fmt::format(
        "trap '' TTOU; IFS= read -r told <&3 && exit; "
        "case $(stty -g) in {0}*) stty {1};; esac",
        // what stands before the characters: the shell that follows may have changed those alone
        SttyForm(raw), SttyForm(usual));
    if (!Spawn(script, ends_of_pipe[0])) close(std::exchange(ends_of_pipe[1], -1));
    close(ends_of_pipe[0]);
    told_ = ends_of_pipe[1];
  }

  void End() {
    if (told_ < 0) return;
    // it reads one line; where it is gone already, SIGPIPE is ignored by the program
    [[maybe_unused]] const ssize_t sent = write(told_, "\n", 1);
    close(std::exchange(told_, -1));
    waitpid(process_, nullptr, 0);
  }

 private:
  bool Spawn(const std::string& script, int told) {
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_adddup2(&files, told, 3);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&files, 4);
    sigset_t signals;
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&attributes, &signals);
    posix_spawnattr_setpgroup(&attributes, 0);  // what is typed to end this one does not end it
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    std::string shell = "/bin/sh", option = "-c", text = script;
    char* const arguments[] = {shell.data(), option.data(), text.data(), nullptr};
    const int error =
        posix_spawn(&process_, shell.c_str(), &files, &attributes, arguments, environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return error == 0;
  }

  pid_t process_ = -1;
  int told_ = -1;  ///< its end for writing; closed by a death, too
};

Keeper keeper;
int living = 0;  ///< RawTerminals

}  // namespace

RawTerminal::RawTerminal() {
  if (living++ > 0) return;
  if (tcgetattr(STDIN_FILENO, &usual) != 0) {
    --living;
    throw LackError(say::NoTerminal());
  }
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
  keeper.Start();  // before there is anything to give back: a kill may come at any moment
  tcsetattr(STDIN_FILENO, TCSANOW, &raw);
}

RawTerminal::~RawTerminal() {
  if (--living > 0) return;
  tcsetattr(STDIN_FILENO, TCSANOW, &usual);
  for (std::size_t i = 0; i < kEnds.size(); ++i) sigaction(kEnds[i], &before_ends[i], nullptr);
  for (std::size_t i = 0; i < kCrashes.size(); ++i) {
    sigaction(kCrashes[i], &before_crashes[i], nullptr);
  }
  sigaction(SIGTSTP, &before_stop, nullptr);
  sigaction(SIGCONT, &before_go_on, nullptr);
  keeper.End();
}

std::unique_ptr<RawTerminal> RawTerminalIfOurs() {
  if (isatty(STDIN_FILENO) == 0) return nullptr;
  const pid_t front = tcgetpgrp(STDIN_FILENO);  // none: it belongs to no session
  if (front > 0 && front != getpgrp()) return nullptr;
  return std::make_unique<RawTerminal>();
}

}  // namespace moontrace
