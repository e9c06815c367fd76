// What the project's pages tell people to type and to read is there.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "tests/sim/cli_fixture.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

const std::vector<std::string> kPages = {
    "README.md",         "CONTRIBUTING.md", "textures/README.md", "devices/README.md",
    "lessons/README.md", "sim/README.md",   "models/README.md",   "tests/README.md"};

/// Each match's first group.
std::vector<std::string> Found(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at) {
    found.push_back((*at)[1]);
  }
  return found;
}

// The door stays a door: two pages of a terminal, then a place to read on.
TEST(Documents, TheDoorIsShort) {
  const std::string readme = ReadAll(SourcePath("README.md"));
  EXPECT_LE(readme.size(), 10000U);
  // what to type stands on the first screen
  EXPECT_LT(readme.find("./moontrace demo"), 2600U);
}

TEST(Documents, EveryCommandAndOptionInThemIsThere) {
  std::size_t lines = 0;
  for (const std::string& page : kPages) {
    const std::string text = ReadAll(SourcePath(page));
    for (const char* pattern :
         {"\n    (?:\\./)?moontrace ([^\n#]*)", "`(?:\\./)?moontrace ([^`\n]*)`"}) {
      for (const std::string& line : Found(text, pattern)) {
        const std::string command = line.substr(0, line.find(' '));
        if (command == "test" || command == "packages" || command == "help" ||
            command == "version" || command == "COMMAND" || command[0] == '-') {
          continue;
        }
        const Outcome help = RunLine({"help", command, "--help-all"});
        ASSERT_EQ(help.code, 0) << page << ": " << line;
        for (const std::string& option : Found(line, "(?:^| )(--[a-z-]+)")) {
          EXPECT_TRUE(std::regex_search(help.out, std::regex("\n" + option + "[: ]")))
              << page << ": " << line;
        }
        ++lines;
      }
    }
  }
  EXPECT_GT(lines, 40U);
}

TEST(Documents, EveryFileTheyNameIsThere) {
  std::size_t files = 0;
  for (const std::string& page : kPages) {
    const std::string text = ReadAll(SourcePath(page));
    const std::string folder = page.substr(0, page.rfind('/') + 1);
    for (const std::string& file :
         Found(text, "`((?:sim|textures|lessons|devices|tests|models|\\.ci)/[\\w./-]+\\.\\w+)`")) {
      if (file.find("NAME") != std::string::npos) continue;
      EXPECT_TRUE(std::filesystem::exists(SourcePath(file))) << page << ": " << file;
      ++files;
    }
    // a model is read, not written: what stands in a command must be there
    for (const std::string& file : Found(text, "\n    [^\n]*--model ([^\\s]+)")) {
      EXPECT_TRUE(std::filesystem::exists(SourcePath(file))) << page << ": " << file;
      ++files;
    }
    for (const std::string& file : Found(text, "\\]\\(([\\w./-]+\\.\\w+)\\)")) {
      EXPECT_TRUE(std::filesystem::exists(SourcePath(folder + file))) << page << ": " << file;
      ++files;
    }
  }
  EXPECT_GT(files, 30U);
}

TEST(Documents, EveryKeyOfALabelIsTold) {
  const std::string page = ReadAll(SourcePath("models/README.md"));
  const std::vector<std::string> keys = Found(ReadAll(SourcePath("sim/physics/label.cpp")),
                                              "(?:table, |table\\.\\w+\\()\"([a-z_]+)\"");
  EXPECT_GT(keys.size(), 20U);
  for (const std::string& key : keys) {
    EXPECT_NE(page.find("`" + key + "`"), std::string::npos) << key;
  }
}

TEST(Documents, TheModelOfTheDoorCarriesItsWord) {
  const Outcome outcome = RunLine({"trace", "--json", "--model", SourcePath("models/sign.xml")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.Json()["text"], "DOOR");
  EXPECT_GE(outcome.Json()["total"]["coverage"], 0.98);
}

}  // namespace
}  // namespace moontrace
