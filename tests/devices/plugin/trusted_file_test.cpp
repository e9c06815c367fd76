#include "devices/plugin/trusted_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "devices/core/device_error.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

class TrustedFile : public testing::Test {
 protected:
  TrustedFile() {
    std::string name = (fs::temp_directory_path() / "moontrace-XXXXXX").string();
    folder = fs::canonical(mkdtemp(name.data()));
    fs::create_directory(folder / "inner");
    file = folder / "inner" / "plugin.so";
    std::ofstream(file) << "content";
    chmod((folder / "inner").c_str(), 0755);
    chmod(file.c_str(), 0644);
  }
  ~TrustedFile() override { fs::remove_all(folder); }

  /// "" if it is opened, else the line with which it is refused.
  static std::string Refusal(const fs::path& path) {
    try {
      const FileDescriptor opened = OpenTrusted(path.string());
      char first = 0;
      return read(opened.get(), &first, 1) == 1 && first == 'c' ? "" : "opened another file";
    } catch (const DeviceError& error) {
      return error.what();
    }
  }
  static bool Ends(const std::string& line, const std::string& end) {
    return line.size() >= end.size() &&
           line.compare(line.size() - end.size(), end.size(), end) == 0;
  }

  fs::path folder, file;
};

TEST_F(TrustedFile, OpensWhatOnlyTheUserCanWrite) {
  EXPECT_EQ(Refusal(file), "");
  EXPECT_EQ(Refusal(folder / "inner" / ".." / "." / "inner" / "plugin.so"), "");
}

TEST_F(TrustedFile, FollowsLinksOfTheUser) {
  fs::create_symlink("inner", folder / "relative");
  fs::create_symlink(file, folder / "absolute");
  EXPECT_EQ(Refusal(folder / "relative" / "plugin.so"), "");
  EXPECT_EQ(Refusal(folder / "absolute"), "");
  fs::create_symlink("loop", folder / "loop");
  EXPECT_NE(Refusal(folder / "loop"), "");
}

TEST_F(TrustedFile, RefusesAFileThatOthersMayWrite) {
  chmod(file.c_str(), 0664);
  EXPECT_TRUE(Ends(Refusal(file), "chmod go-w " + file.string())) << Refusal(file);
}

TEST_F(TrustedFile, RefusesAFolderAboveThatOthersMayWrite) {
  chmod(folder.c_str(), 0777);
  EXPECT_TRUE(Ends(Refusal(file), "chmod go-w " + folder.string())) << Refusal(file);
  // Also where a link leads through it.
  fs::create_symlink(file, folder / "inner" / "link");
  EXPECT_TRUE(Ends(Refusal(folder / "inner" / "link"), "chmod go-w " + folder.string()));
}

TEST_F(TrustedFile, RefusesAFileInAFolderThatAllMayWrite) {
  chmod((folder / "inner").c_str(), 01777);
  const std::string line = Refusal(file);
  EXPECT_NE(line.find((folder / "inner").string()), std::string::npos) << line;
}

TEST_F(TrustedFile, RefusesWhatBelongsToAnotherUser) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can give files away";
  constexpr ::uid_t kOther = 12345;
  ASSERT_EQ(chown(file.c_str(), kOther, kOther), 0);
  EXPECT_TRUE(Ends(Refusal(file), "chown 0 " + file.string())) << Refusal(file);
  ASSERT_EQ(chown(file.c_str(), 0, 0), 0);
  ASSERT_EQ(chown((folder / "inner").c_str(), kOther, kOther), 0);
  EXPECT_TRUE(Ends(Refusal(file), "chown 0 " + (folder / "inner").string())) << Refusal(file);
}

TEST_F(TrustedFile, RefusesWhatIsNoFile) {
  EXPECT_NE(Refusal(folder), "");
  EXPECT_NE(Refusal(folder / "missing"), "");
  EXPECT_NE(Refusal(file / "below"), "");
  EXPECT_NE(Refusal(""), "");
  EXPECT_NE(Refusal("/dev/null"), "");
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_NE(Refusal(folder / "pipe"), "");
}

}  // namespace
}  // namespace moontrace
