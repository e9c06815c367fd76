#include "sim/session/loop_drive.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/sim/cli_fixture.h"

namespace moontrace {
namespace {

class LoopDrive : public CliTest {};

// Only a change of state was told.
TEST_F(LoopDrive, AnswersAStopAndAGoThatChangeNothing) {
  const Outcome outcome = RunLine({"loop", "MOON", "--page", "60x40", "--size-mm", "20"},
                                  "go\nstop\nstop\npause\ngo\ngo\nstop\nquit\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  std::vector<std::string> told;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) {
    const bool of_stop = line.rfind("Stopped", 0) == 0 || line.rfind("Not stopped", 0) == 0 ||
                         line.rfind("Going on", 0) == 0;
    if (of_stop) told.push_back(line);
  }
  const std::string not_stopped = "Not stopped: go on feeling.",
                    stopped = "Stopped. Say go to go on.",
                    already = "Stopped already. Say go to go on.", goes_on = "Going on.";
  EXPECT_EQ(told, (std::vector<std::string>{not_stopped, stopped, already, already, goes_on,
                                            not_stopped, stopped}))
      << outcome.out;
}

}  // namespace
}  // namespace moontrace
