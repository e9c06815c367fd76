#include "sim/app/manual.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <sstream>

#include "tests/sim/cli_fixture.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

class ManualTest : public CliTest {
 protected:
  std::string Asked(const std::string& what) { return RunLine({"help", what}).out; }
  /// What a shell answers to a script.
  std::string Shell(const std::string& script) {
    WriteAll(In("script.bash"), script);
    const std::string out = In("out");
    const int code = std::system(("bash " + In("script.bash") + " >" + out + " 2>&1").c_str());
    EXPECT_EQ(code, 0) << ReadAll(out);
    return ReadAll(out);
  }
};

TEST_F(ManualTest, HasEveryOptionOfTheReference) {
  const std::string page = Asked("--man");
  std::istringstream reference(ReadAll(SourcePath("sim/OPTIONS.md")));
  std::size_t options = 0;
  for (std::string line; std::getline(reference, line);) {
    if (line.rfind("| `--", 0) != 0) continue;
    const std::string name = line.substr(3, line.find_first_of(" `", 5) - 3);
    std::string escaped;
    for (const char c : name) escaped += c == '-' ? std::string("\\-") : std::string(1, c);
    EXPECT_NE(page.find("\\fB" + escaped + "\\fR"), std::string::npos) << name;
    ++options;
  }
  EXPECT_GT(options, 100U);
}

TEST_F(ManualTest, ALineIsARequestOnlyWhereOneIsMeant) {
  std::istringstream page(Asked("--man"));
  const std::set<std::string> meant{".TH", ".SH", ".SS", ".TP", ".PP", ".B", ".I"};
  for (std::string line; std::getline(page, line);) {
    EXPECT_FALSE(line.empty()) << "an empty line is a gap of its own";
    if (line.rfind('.', 0) != 0 && line.rfind('\'', 0) != 0) continue;
    EXPECT_EQ(meant.count(line.substr(0, line.find(' '))), 1U) << line;
  }
}

TEST_F(ManualTest, BashCompletesCommandsAndOptions) {
  const std::string answer =
      Shell(Asked("--bash") +
            "COMP_WORDS=(moontrace re); COMP_CWORD=1; _moontrace; echo \"${COMPREPLY[*]}\"\n"
            "COMP_WORDS=(moontrace read --tu); COMP_CWORD=2; _moontrace; echo \"${COMPREPLY[*]}\"\n"
            "COMP_WORDS=(moontrace read x); COMP_CWORD=2; _moontrace; echo \"${COMPREPLY[*]}.\"\n");
  EXPECT_EQ(answer, "read report records recognise replay\n--turn --tutor\n.\n");
}

}  // namespace
}  // namespace moontrace
