#include "sim/session/device_opening.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "devices/core/device_error.h"
#include "devices/hid/homing.h"
#include "sim/console/console.h"
#include "tests/devices/fake_hid.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

const std::string kProfiles = SourcePath("devices/profiles");

std::unique_ptr<Device> Open(const std::string& name, std::vector<std::string>& told,
                             const std::atomic<bool>* stop = nullptr) {
  return OpenHomed(
      {name}, kProfiles, [&told](std::string_view line) { told.emplace_back(line); }, stop);
}

TEST(SlowOpenHomed, AsksForTheRestAndTheMove) {
  const FakeHid fake("woodenhaptics");  // with somebody who does what is asked
  std::vector<std::string> told;
  const auto device = Open("woodenhaptics", told);
  EXPECT_EQ(told, (std::vector<std::string>{std::string(SentenceOf(HomingStep::kRest)),
                                            std::string(SentenceOf(HomingStep::kMove))}));
  DeviceState state;
  EXPECT_NE(device->Read(state), DeviceStatus::kNotReady);
}

TEST(OpenHomed, AsksNothingOfADeviceThatKnowsWhereItIs) {
  const FakeHid fake("moontrace-raw");
  std::vector<std::string> told;
  EXPECT_NE(Open("moontrace-raw", told), nullptr);
  EXPECT_TRUE(told.empty());
}

TEST(OpenHomed, EndsWhenItIsStoppedOrUnplugged) {
  std::vector<std::string> told;
  {
    const FakeHid fake("polhem");
    const std::atomic<bool> stop{true};
    EXPECT_THROW(Open("polhem", told, &stop), Interrupted);
  }
  const FakeHid fake("polhem", "unplug@100");
  try {
    Open("polhem", told);
    FAIL() << "homed";
  } catch (const DeviceError& error) {
    // "within 120 s" was said a moment after it had begun
    EXPECT_STREQ(error.what(),
                 "polhem: was lost before it lay in its rest: look at its plug and its power");
  }
}

// `loop --seconds 0.3` ends though nobody homes the arm: the emulated person needs 2.3 s for it.
TEST(OpenHomed, WaitsNoLongerThanItIsTold) {
  const FakeHid fake("polhem");
  try {
    OpenHomed(
        {"polhem"}, kProfiles, [](std::string_view) {}, nullptr, 0.3);
    FAIL() << "homed";
  } catch (const DeviceError& error) {
    // how to do it, since "try again" alone helps nobody
    EXPECT_STREQ(error.what(),
                 "polhem: was not put in its rest within 0.3 s: begin again, and move the arm a "
                 "little, lay it in its rest, hold it still for a second");
  }
}

}  // namespace
}  // namespace moontrace
