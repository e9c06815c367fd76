#include "textures/base/output_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "textures/base/error.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

class OutputFile : public testing::Test {
 protected:
  OutputFile()
      : folder_(fs::temp_directory_path() / ("moontrace-out-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~OutputFile() override { fs::remove_all(folder_); }
  std::string In(const std::string& name) const { return (folder_ / name).string(); }
  static std::string Held(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::size_t Files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }
  std::string Refusal(const std::string& path) const {
    for (const bool writes : {false, true}) {
      try {
        writes ? WriteWhole(path, "new") : RequireWritable(path);
        ADD_FAILURE() << path << " was taken";
      } catch (const LackError& error) {
        if (writes) return error.what();
      }
    }
    return {};
  }
  fs::path folder_;
};

TEST_F(OutputFile, IsWholeAndNothingLiesBesideIt) {
  WriteWhole(In("a"), "one");
  WriteWhole(In("a"), std::string("two\0", 4));
  EXPECT_EQ(Held(In("a")), std::string("two\0", 4));
  RequireWritable(In("b"));
  EXPECT_EQ(Files(), 1U);
}

TEST_F(OutputFile, GoesWhereASymbolicLinkLeads) {
  WriteWhole(In("target"), "old");
  fs::create_symlink(In("target"), In("link"));
  fs::create_symlink("not yet", In("early"));  // relative to its folder, and leading nowhere yet
  fs::create_symlink("round", In("round"));
  WriteWhole(In("link"), "new");
  WriteWhole(In("early"), "made");
  EXPECT_TRUE(fs::is_symlink(In("link")));
  EXPECT_EQ(Held(In("target")), "new");
  EXPECT_EQ(Held(In("not yet")), "made");
  EXPECT_NE(Refusal(In("round")).find("in a circle"), std::string::npos);
}

TEST_F(OutputFile, LeavesPipesDevicesAndFoldersAlone) {
  ASSERT_EQ(mkfifo(In("pipe").c_str(), 0600), 0);
  fs::create_symlink("/dev/null", In("null"));
  fs::create_directory(In("folder"));
  EXPECT_EQ(Refusal(In("pipe")),
            In("pipe") + ": cannot be written (it is a pipe or a device); choose another place");
  EXPECT_NE(Refusal(In("null")).find("a pipe or a device"), std::string::npos);
  EXPECT_NE(Refusal(In("folder")).find("it is a folder"), std::string::npos);
  EXPECT_TRUE(fs::is_fifo(In("pipe")));
  EXPECT_TRUE(fs::is_symlink(In("null")));
  EXPECT_EQ(Files(), 3U);
}

TEST_F(OutputFile, IsNotNamedAsStandardInputIs) {
  EXPECT_NE(Refusal("-").find("it stands for standard input"), std::string::npos);
  EXPECT_NE(Refusal(In("none/a")).find("No such file"), std::string::npos);
}

}  // namespace
}  // namespace moontrace
