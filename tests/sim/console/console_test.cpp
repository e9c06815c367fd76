#include "sim/console/console.h"

#include <gtest/gtest.h>

#include <sstream>

namespace moontrace {
namespace {

struct Lines {
  std::istringstream in;
  std::ostringstream out, err;
  Console console{in, out, err};

  explicit Lines(const char* called) { console.SetCalled(called, {"demo", "trace", "help"}); }
  std::string Told(const char* line) {
    out.str("");
    console.Result(line);
    return out.str();
  }
};

TEST(ConsoleCalled, CommandLinesBeginAsTheProgramWasCalled) {
  Lines lines("./moontrace");
  EXPECT_EQ(lines.Told("Next: moontrace trace \"moontrace\""),
            "Next: ./moontrace trace \"moontrace\"\n");
  EXPECT_EQ(lines.Told("moontrace demo; \"moontrace help\""),
            "./moontrace demo; \"./moontrace help\"\n");
  lines.console.Help("moontrace demo: a word.\n");
  lines.console.Remark("see moontrace help");
  lines.console.Error("no point: write moontrace trace X");
  EXPECT_EQ(lines.out.str(), "./moontrace demo; \"./moontrace help\"\n./moontrace demo: a word.\n");
  EXPECT_EQ(lines.err.str(), "see ./moontrace help\nno point: write ./moontrace trace X\n");
}

TEST(ConsoleCalled, WhatIsNoCommandLineStaysAsItIs) {
  Lines lines("./moontrace");
  for (const char* line : {"moontrace 0.1.0, MuJoCo 2.2.2", "moontrace demonstrates", "moontrace",
                           "./moontrace demo", "my-moontrace trace", "moontrace-demo"}) {
    EXPECT_EQ(lines.Told(line), std::string(line) + "\n");
  }
  lines.out.str("");
  lines.console.Path("moontrace demo");
  lines.console.Json("\"moontrace demo\"");
  EXPECT_EQ(lines.out.str(), "moontrace demo\n\"moontrace demo\"\n");
}

TEST(ConsoleCalled, LinesAreBrokenAfterwards) {
  Lines lines("/home/ada/reading/moontrace");
  lines.console.SetColumns([] { return 40; }, [] { return 40; });
  EXPECT_EQ(lines.Told("Next, try your own: moontrace trace moon"),
            "Next, try your own:\n/home/ada/reading/moontrace trace moon\n");
}

TEST(ConsoleCalled, InstalledItIsCalledByItsName) {
  EXPECT_EQ(Lines("").Told("moontrace demo"), "moontrace demo\n");
}

}  // namespace
}  // namespace moontrace
