#include "sim/app/commands.h"

#include <gtest/gtest.h>

#include "tests/sim/cli_fixture.h"

namespace moontrace {
namespace {

class DemoCommand : public CliTest {};

TEST_F(DemoCommand, TracesFourSizesAndABlankPageAndLeavesPictures) {
  const Outcome outcome = RunLine({"demo", "--folder", In("demo")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  for (const char* size : {"40 mm letters: ", "20 mm letters: ", "10 mm letters: ",
                           "6 mm letters: ", "Blank page: "}) {
    EXPECT_NE(outcome.out.find(std::string("\n") + size), std::string::npos) << size;
  }
  EXPECT_NE(outcome.out.find("\n" + In("demo") + "\n"), std::string::npos) << outcome.out;
  ExpectTextFace(outcome.out);
  std::size_t pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(In("demo"))) {
    EXPECT_GT(entry.file_size(), 1000U);
    ++pictures;
  }
  EXPECT_EQ(pictures, 5U);
}

TEST_F(DemoCommand, JsonHasARowForEachSize) {
  const Outcome outcome = RunLine({"demo", "--folder", In("demo"), "--json", "--quiet"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(outcome.err.empty());
  const nlohmann::json rows = outcome.Json()["sizes"];
  ASSERT_EQ(rows.size(), 5U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_GE(rows[i]["coverage"], 0.98) << rows[i];
  EXPECT_TRUE(rows[4]["blank"]);
  EXPECT_GT(rows[4]["mean_error_mm"], rows[1]["mean_error_mm"]);
}

TEST_F(DemoCommand, OtherSeedsTrembleOtherwise) {
  const Outcome one = RunLine({"demo", "--folder", In("demo"), "--seed", "1"});
  EXPECT_EQ(one.out, RunLine({"demo", "--folder", In("demo")}).out);
  EXPECT_NE(one.out, RunLine({"demo", "--folder", In("demo"), "--seed", "2"}).out);
}

TEST_F(DemoCommand, UnwritableFolderIsNamed) {
  WriteAll(In("file"), "");
  const Outcome outcome = RunLine({"demo", "--folder", In("file") + "/demo"});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(Lines(outcome.err).size(), 1U);
  EXPECT_NE(outcome.err.find(In("file")), std::string::npos);
}

}  // namespace
}  // namespace moontrace
