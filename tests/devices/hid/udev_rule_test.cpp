#include "devices/hid/udev_rule.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "devices/catalogue/catalogue.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

const std::string kDevices = SourcePath("devices");

// The line of mujoco-and-hid reference 2.5 for OpenFFBoard, without its spaces.
TEST(UdevRule, NamesTheHidParentInUpperCase) {
  EXPECT_EQ(UdevRule({0x1209, 0xffb0, true}),
            "KERNEL==\"hidraw*\",SUBSYSTEM==\"hidraw\",KERNELS==\"*:1209:FFB0.*\","
            "TAG+=\"uaccess\"");
}

TEST(UdevFile, IsTheShippedOne) {
  std::ifstream file(kDevices + "/udev/70-moontrace-hid.rules");
  const std::string shipped{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  EXPECT_EQ(shipped, UdevFile(LoadProfiles(kDevices + "/profiles")))
      << "make it anew: moontrace devices --udev > devices/udev/70-moontrace-hid.rules";
}

TEST(UdevFile, LeavesOutBorrowedIdsAndPucks) {
  DeviceProfile board, puck, stick;
  board.ids = {{0x16c0, 0x0486, false}};
  puck.kind = DeviceKind::kPuck;
  puck.ids = {{0x256f, 0xc62e, true}};
  stick.ids = {{0x045e, 0x001b, true}};
  const std::string file = UdevFile({board, puck, stick});
  EXPECT_EQ(file.find("16C0"), std::string::npos);
  EXPECT_EQ(file.find("256F"), std::string::npos);
  EXPECT_NE(file.find(UdevRule({0x045e, 0x001b, true})), std::string::npos);
}

}  // namespace
}  // namespace moontrace
