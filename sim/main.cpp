#include <unistd.h>
#include <atomic>

#include <csignal>  // POSIX: sigaction too, as a signal must end a wait for standard input
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "sim/app/cli.h"
#include "sim/view/view_window.h"

namespace {

std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set within a signal handler");

extern "C" void AskToStop(int) { stop_asked.store(true); }

/// The first signal asks the work to stop and clean up, a second one ends the process at once.
void StopOn(int signal_number) {
  struct sigaction action = {};
  action.sa_handler = AskToStop;
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // and no SA_RESTART, so that reading ends
  sigaction(signal_number, &action, nullptr);
}

}  // namespace

int main(int argc, char** argv) {
  StopOn(SIGINT);
  StopOn(SIGTERM);
  // a terminal that closes must not leave force on a device
  StopOn(SIGHUP);
  StopOn(SIGQUIT);
  // A limit on file sizes and a reader who left are failures of writing, with their line and their
  // clean-up, not sudden deaths.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  moontrace::Console console(std::cin, std::cout, std::cerr, &stop_asked);
  console.SetColumns([] { return moontrace::TerminalColumns(STDOUT_FILENO); },
                     [] { return moontrace::TerminalColumns(STDERR_FILENO); });
  // The launcher tells how it was called: it is what its user can type again.
  const char* called = std::getenv("MOONTRACE_CALLED");
  console.SetCalled(called == nullptr ? "" : called, moontrace::TypedAfterName());
  const int code = moontrace::RunCli(std::vector<std::string>(argv + 1, argv + argc), console);
  if (moontrace::ViewWindow::DisplayWasLost()) {
    std::cout.flush();
    std::cerr.flush();
    std::_Exit(code);
  }
  return code;
}
