#include <atomic>
#include <csignal>
#include <iostream>
#include <string>
#include <vector>

#include "sim/app/cli.h"

namespace {

std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set within a signal handler");

extern "C" void AskToStop(int) { stop_asked.store(true); }

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, AskToStop);
  std::signal(SIGTERM, AskToStop);
  moontrace::Console console(std::cin, std::cout, std::cerr, &stop_asked);
  return moontrace::RunCli(std::vector<std::string>(argv + 1, argv + argc), console);
}
