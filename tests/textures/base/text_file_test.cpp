#include "textures/base/text_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "textures/base/error.h"

namespace moontrace {
namespace {

class TextPipe : public testing::Test {
 protected:
  TextPipe() {
    std::string name = (std::filesystem::temp_directory_path() / "moontrace-pipe-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~TextPipe() override { std::filesystem::remove_all(folder_); }
  std::string In(const char* name) const { return (folder_ / name).string(); }
  static std::string Refusal(const std::string& path) {
    try {
      ReadTextFile(path, 100);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }

  std::filesystem::path folder_;
};

TEST_F(TextPipe, IsNoFile) {
  ASSERT_EQ(mkfifo(In("pipe").c_str(), 0600), 0);  // opening it would wait for its writer
  EXPECT_EQ(Refusal(In("pipe")),
            In("pipe") + ": is no regular file; name one, not a pipe or a device");
  std::filesystem::create_symlink("pipe", In("link"));
  EXPECT_EQ(Refusal(In("link")),
            In("link") + ": is no regular file; name one, not a pipe or a device");
  EXPECT_EQ(Refusal("/dev/zero"),
            "/dev/zero: is no regular file; name one, not a pipe or a device");
  EXPECT_NE(Refusal(folder_.string()).find("is a folder"), std::string::npos);
  EXPECT_NE(Refusal(In("none")).find("cannot be opened"), std::string::npos);
}

TEST_F(TextPipe, IsReadWhereOneMayBeNamed) {
  ASSERT_EQ(mkfifo(In("pipe").c_str(), 0600), 0);
  std::thread writer([this] { std::ofstream(In("pipe")) << "moon"; });
  EXPECT_EQ(ReadTextOrPipe(In("pipe"), 100), "moon");
  writer.join();
}

}  // namespace
}  // namespace moontrace
