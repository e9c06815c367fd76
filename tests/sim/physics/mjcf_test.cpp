#include "sim/physics/mjcf.h"

#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/sim/record_fixture.h"
#include "tests/sim/scene_fixture.h"

namespace moontrace {
namespace {

/// Why a model is not given to MuJoCo; empty if it is.
std::string RefusalOf(const std::string& parts, const std::string& folder = "") {
  return ErrorOf(
      [&] { PrepareMjcf("<mujoco>" + parts + "</mujoco>", folder, "m.xml", "<mujoco/>"); });
}

bool IsTooLarge(const std::string& parts, const std::string& what, const std::string& folder = "") {
  const std::string line = RefusalOf(parts, folder);
  return IsOneLine(line) && line.rfind("m.xml: ", 0) == 0 && Holds(line, what) &&
         Holds(line, "more than");
}

std::string Times(int count, const std::string& part) {
  std::string parts;
  for (int i = 0; i < count; ++i) parts += part;
  return parts;
}

TEST(RequireModestSizes, RefusesGridsThatFillTheMemory) {
  EXPECT_TRUE(IsTooLarge("<asset><hfield nrow='30000' ncol='30000'/></asset>", "900000000"));
  EXPECT_TRUE(IsTooLarge("<asset><hfield nrow='1e9' ncol='1e9'/></asset>", "<hfield>"));
  const std::string half = "<hfield nrow='4096' ncol='2049'/>";
  EXPECT_TRUE(IsTooLarge("<asset>" + half + half + "</asset>", "<hfield>"));
  EXPECT_TRUE(
      IsTooLarge("<asset><texture type='2d' width='30000' height='30000'/></asset>", "<texture>"));
  // six square faces, whose bytes do not fit an int: MuJoCo 2.2.2 died of it
  EXPECT_TRUE(
      IsTooLarge("<asset><texture type='cube' width='16000' height='1'/></asset>", "1536000000"));
  EXPECT_EQ(RefusalOf("<asset><hfield nrow='4096' ncol='4096'/>"
                      "<texture type='2d' width='8192' height='8192'/></asset>"),
            "");
}

TEST(RequireModestSizes, RefusesWhatIsSetAsideForNothing) {
  for (const char* size : {"njmax='20000'", "nconmax='2000000000'", "nstack='2000000000'",
                           "nuserdata='2000000000'", "nkey='100000000'", "nuser_body='500000000'",
                           "nuser_sensor='1e300'", "memory='10G'", "memory='1E'"}) {
    EXPECT_TRUE(IsTooLarge("<size " + std::string(size) + "/>", "<size>")) << size;
  }
  EXPECT_EQ(RefusalOf("<size njmax='500' nconmax='-1' nkey='20' nuser_geom='3' memory='100M'/>"),
            "");
  EXPECT_TRUE(IsTooLarge("<option iterations='2000000000'/>", "iterations"));
  EXPECT_TRUE(IsTooLarge("<visual><global offwidth='100000'/></visual>", "offwidth"));
}

TEST(RequireModestSizes, CountsWhatIsMadeOfFewWords) {
  EXPECT_TRUE(IsTooLarge("<worldbody>" + Times(10001, "<geom/>") + "</worldbody>", "elements"));
  EXPECT_TRUE(IsTooLarge("<worldbody><composite count='100 100 100'/></worldbody>", "<composite>"));
  EXPECT_TRUE(IsTooLarge("<worldbody><flexcomp count='1 99999'/></worldbody>", "<flexcomp>"));
  const std::string nested =
      "<replicate count='200'><replicate count='200'><geom/></replicate>"
      "</replicate>";
  EXPECT_TRUE(IsTooLarge("<worldbody>" + nested + "</worldbody>", "<geom>"));
  EXPECT_EQ(RefusalOf("<worldbody>" + Times(20, "<replicate count='99'><geom/></replicate>") +
                      "<composite count='8 8 1'/></worldbody>"),
            "");
  // never parsed
  EXPECT_TRUE(IsTooLarge(Times(100001, "<a>"), "tags"));
}

class NamedFiles : public testing::Test {
 protected:
  void Write(const std::string& name, const std::string& bytes) {
    test::WriteBytes(folder_ / name, bytes);
  }
  test::TempFolder folder_;
};

// They would weigh the inserted bodies too, and the model's own differently for them.
TEST(PrepareMjcf, RefusesWhatChangesAllMasses) {
  const std::string total = RefusalOf("<compiler settotalmass='20'/>");
  EXPECT_TRUE(IsOneLine(total) && Holds(total, "m.xml: compiler settotalmass")) << total;
  const std::string least = RefusalOf("<compiler boundmass='0.5'/>");
  EXPECT_TRUE(IsOneLine(least) && Holds(least, "m.xml: compiler boundmass")) << least;
  EXPECT_EQ(RefusalOf("<compiler boundmass='0.001' settotalmass='-1'/>"), "");
  const char* own =
      "<compiler settotalmass='20'/><worldbody><body name='moontrace_proxy'/></worldbody>";
  EXPECT_EQ(RefusalOf(own), "");  // it is the model's own proxy
}

TEST_F(NamedFiles, AreMeasuredBeforeTheyAreRead) {
  Write("huge.stl", "");
  std::filesystem::resize_file(folder_ / "huge.stl", std::uintmax_t{3} << 30);  // sparse
  EXPECT_TRUE(IsTooLarge("<asset><mesh file='huge.stl'/></asset>", "<mesh>", folder_.path()));
  EXPECT_TRUE(IsTooLarge("<compiler strippath='true'/><asset><mesh file='far/huge.stl'/></asset>",
                         "<mesh>", folder_.path()));
  std::filesystem::create_directory(folder_ / "parts");
  std::filesystem::rename(folder_ / "huge.stl", folder_ / "parts/huge.stl");
  EXPECT_TRUE(IsTooLarge("<compiler meshdir='parts'/><asset><mesh file='huge.stl'/></asset>",
                         "<mesh>", folder_.path()));
  EXPECT_EQ(RefusalOf("<asset><mesh file='nowhere.stl'/></asset>", folder_.path()), "");
}

TEST_F(NamedFiles, OfPicturesAreMeasuredUnpacked) {
  // a signature and the first chunk: 20000 times 20000, which packs into 400 kB
  const std::string head("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0N \0\0N \x08\0\0\0\0", 29);
  Write("bomb.png", head);
  for (const char* tag : {"hfield", "texture"}) {
    const std::string asset = "<asset><" + std::string(tag) + " file='bomb.png'/></asset>";
    EXPECT_TRUE(IsTooLarge(asset, "400000000", folder_.path())) << tag;
  }
}

TEST_F(NamedFiles, ThatCouldBeWaitedForWithoutEndAreRefused) {
  ASSERT_EQ(mkfifo((folder_ / "pipe.stl").c_str(), 0600), 0);
  const std::string line = RefusalOf("<asset><mesh file='pipe.stl'/></asset>", folder_.path());
  EXPECT_TRUE(IsOneLine(line) && Holds(line, "no regular file")) << line;
}

TEST_F(NamedFiles, OfIncludesAreBoundedTogether) {
  const std::string blank = "<a>" + std::string(std::size_t{23} << 20, ' ') + "</a>";
  for (const char* name : {"a.xml", "b.xml", "c.xml"}) Write(name, blank);
  const std::string line = RefusalOf(
      "<include file='a.xml'/><include file='b.xml'/><include file='c.xml'/>", folder_.path());
  EXPECT_TRUE(IsOneLine(line) && Holds(line, "more than 64 MB")) << line;
}

}  // namespace
}  // namespace moontrace
