#pragma once

#include <string>
#include <vector>

#include "tests/sim/cli_fixture.h"

namespace moontrace {

/// A small course with a step of every kind, in a folder of the test's own.
class LearnTest : public CliTest {
 protected:
  LearnTest() {
    std::filesystem::create_directories(folder_ / "course");
    WriteAll(folder_ / "course" / "course.toml", R"(
title = "Small course"
language = "en"
script = "moon"
grade = 1
sizes_mm = [16, 10]
lessons = ["one", "two"]
)");
    WriteAll(folder_ / "course" / "one.toml", R"(
title = "First lesson"
new = ["i", "l"]
[hints]
i = "I is one upright line."
[[steps]]
kind = "explore"
say = """
Feel the line.
It is upright."""
text = "i"
[[steps]]
kind = "demonstrate"
[[steps]]
kind = "trace"
[[steps]]
kind = "recognise"
[[steps]]
kind = "recognise"
question = "pick"
items = ["i", "l"]
[[steps]]
kind = "recognise"
question = "same"
items = ["i", "l"]
[[steps]]
kind = "read"
text = "ill"
[[steps]]
kind = "test"
)");
    WriteAll(folder_ / "course" / "two.toml", R"(
title = "Second lesson"
needs = ["one"]
new = ["t"]
[[steps]]
kind = "trace"
)");
  }

  std::vector<std::string> Learn(const std::vector<std::string>& more = {}) const {
    return With({"learn", "--course", In("course"), "--records", In("records.sqlite"), "--learner",
                 "ann", "--device", "simulated"},
                more);
  }
};

/// Steps of the first lesson.
inline constexpr std::size_t kStepsOfFirst = 8;

}  // namespace moontrace
