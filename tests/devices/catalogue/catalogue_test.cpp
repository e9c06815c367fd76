#include "devices/catalogue/catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "devices/core/device_error.h"
#include "tests/devices/device_run.h"
#include "tests/devices/fake_hid.h"
#include "tests/source_path.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

const std::string kProfiles = SourcePath("devices/profiles");

std::vector<std::string> Names(const std::vector<DeviceEntry>& entries) {
  std::vector<std::string> names;
  for (const DeviceEntry& entry : entries) names.push_back(entry.name);
  std::sort(names.begin(), names.end());
  return names;
}

std::string Refusal(const std::string& name) {
  DeviceRequest request;
  request.name = name;
  try {
    OpenDevice(request, kProfiles);
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "not refused";
}

bool Has(const std::string& line, const std::string& part) {
  return line.find(part) != std::string::npos && line.find('\n') == std::string::npos;
}

TEST(Catalogue, IsEmptyWhereNothingIsPluggedIn) {
  const FakeHid fake("");
  EXPECT_TRUE(ListDevices(kProfiles).empty());
}

TEST(Catalogue, RecognisesEveryKindAmongOthers) {
  // The last three have borrowed ids: the arms are told apart by the size of their reports, and the
  // self-built device, which has the third one's, by its usage.
  const FakeHid fake("pid,pid-array,spacemouse,woodenhaptics,polhem,polhem-teensy,moontrace-raw");
  const std::vector<DeviceEntry> entries = ListDevices(kProfiles);
  EXPECT_EQ(Names(entries),
            (std::vector<std::string>{"moontrace-raw", "openffboard", "polhem", "polhem-teensy",
                                      "spacemouse", "vpforce-rhino", "woodenhaptics"}));
  for (const DeviceEntry& entry : entries) EXPECT_EQ(entry.problem, "") << entry.name;
}

TEST(Catalogue, NumbersDevicesOfOneKind) {
  const FakeHid fake("pid,pid,pid");
  EXPECT_EQ(Names(ListDevices(kProfiles)),
            (std::vector<std::string>{"openffboard", "openffboard-2", "openffboard-3"}));
}

TEST(Catalogue, OpensEachKindByItsName) {
  for (const std::string kind : {"pid", "pid-array", "spacemouse", "woodenhaptics", "polhem",
                                 "polhem-teensy", "moontrace-raw"}) {
    const FakeHid fake(kind);
    const std::vector<DeviceEntry> entries = ListDevices(kProfiles);
    ASSERT_EQ(entries.size(), 1u) << kind;
    DeviceRequest request;
    request.name = entries[0].name;
    const std::unique_ptr<Device> device = OpenDevice(request, kProfiles);
    ASSERT_NE(device, nullptr) << kind;
    EXPECT_EQ(device->Limits().pushes, entries[0].profile.limits.pushes) << kind;
    const DeviceRun run = RunDevice(*device, 300, {0, 0, 0});
    EXPECT_EQ(run.lost, 0) << kind;
    // Arms wait to be homed, all others tell where they are.
    EXPECT_TRUE(!run.states.empty() || run.not_ready > 0) << kind;
  }
}

TEST(Catalogue, TellsWhatASelfBuiltDeviceSaysOfItself) {
  const FakeHid fake("moontrace-raw");
  const std::vector<DeviceEntry> entries = ListDevices(kProfiles);
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_NEAR(entries[0].profile.limits.peak_force, 5, 1e-9);  // the emulator's, not the profile's
}

TEST(Catalogue, TellsTheUdevLineWherePermissionIsRefused) {
  const FakeHid fake("pid", "refused");
  const std::vector<DeviceEntry> entries = ListDevices(kProfiles);
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].problem, "no permission");
  EXPECT_TRUE(Has(entries[0].rule, "KERNELS==\"*:1209:FFB0.*\"")) << entries[0].rule;
  EXPECT_TRUE(Has(Refusal("openffboard"), "\"moontrace devices\" tells how to give it"));
}

TEST(Catalogue, TellsWhatABrokenDescriptorLacks) {
  const FakeHid fake("pid", "wrong-descriptor");
  const std::vector<DeviceEntry> entries = ListDevices(kProfiles);
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_NE(entries[0].problem, "");
  EXPECT_NE(Refusal("openffboard"), "not refused");
}

TEST(Catalogue, UnknownNameIsToldWithTheNearest) {
  const FakeHid fake("pid,spacemouse");
  EXPECT_TRUE(Has(Refusal("openfboard"), "did you mean openffboard?"));
  EXPECT_TRUE(Has(Refusal("zzz"), "there are")) << Refusal("zzz");
}

TEST(Catalogue, SaysThatNothingIsPluggedIn) {
  const FakeHid fake("");
  EXPECT_TRUE(Has(Refusal("openffboard"), "none is plugged in"));
  EXPECT_EQ(Refusal("openffboard").rfind("openffboard: none is plugged in; ", 0), 0u);
  EXPECT_EQ(Refusal("zzz"), "no device is called \"zzz\": none is plugged in");
}

TEST(Catalogue, NamesTheNearestKindThatIsKnownWhereItIsNotPluggedIn) {
  const FakeHid fake("spacemouse");
  EXPECT_TRUE(Has(Refusal("openffbord"), "did you mean openffboard? That is not plugged in"));
  EXPECT_TRUE(Has(Refusal("spacemose"), "did you mean spacemouse?"));
  EXPECT_FALSE(Has(Refusal("spacemose"), "not plugged in"));
  EXPECT_EQ(Refusal("polhem").rfind("polhem: none is plugged in; ", 0), 0u);
}

TEST(Catalogue, NamesTheNearestProfile) {
  const auto refusal = [](const std::string& name) -> std::string {
    try {
      FindProfile(name, kProfiles);
    } catch (const InputError& error) {
      return error.what();
    }
    return "not refused";
  };
  EXPECT_EQ(refusal("opnffboard"),
            "device profile 'opnffboard': there is none; did you mean openffboard?");
  EXPECT_TRUE(Has(refusal("zzz"), "name a .toml file, or one of generic-pid, "));
}

TEST(Catalogue, RefusesAFolderWithoutProfiles) {
  EXPECT_THROW(ListDevices("/nonexistent"), DeviceError);
}

}  // namespace
}  // namespace moontrace
