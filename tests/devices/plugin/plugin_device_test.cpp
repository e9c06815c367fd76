#include "devices/plugin/plugin_device.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <glm/glm.hpp>
#include <string>
#include <thread>
#include <utility>

#include "devices/core/device_error.h"
#include "devices/plugin/plugin_process.h"
#include "tests/devices/plugin_fixture.h"
#include "tests/signal_child.h"

namespace moontrace {
namespace {

class PluginDeviceTest : public PluginTest {
 protected:
  /// The one line with which opening is refused.
  std::string Refusal(const std::string& name) const {
    try {
      MakePluginDevice(Plugin(name), 0.001);
    } catch (const DeviceError& error) {
      return error.what();
    }
    return "not refused";
  }
  static bool Has(const std::string& line, const std::string& part) {
    return line.find(part) != std::string::npos && line.find('\n') == std::string::npos;
  }
};

TEST_F(PluginDeviceTest, TellsTheLimitsThatThePluginDescribes) {
  const DeviceProfile profile = DescribePlugin(Plugin("template"));
  EXPECT_EQ(profile.title, "Spring and mass (template)");
  EXPECT_EQ(profile.limits.peak_force, 3);
  EXPECT_EQ(profile.limits.continuous_force, 1);
  EXPECT_EQ(profile.limits.heat_time, 20);
  EXPECT_EQ(profile.limits.workspace_D, glm::dvec3(0.08));
  EXPECT_EQ(profile.limits.dead_man, 0.02);
  // By hand from the template: 2 b / T with b = 2 N s/m, T = a period of 1 ms and twice 1 ms, is
  // 1333 N/m, so that the maker's 1000 N/m is the least.
  EXPECT_EQ(MakePluginDevice(Plugin("template"), 0.001)->Limits().stiffness, 1000);
}

TEST_F(PluginDeviceTest, SpringComesToRestAtForceOverStiffness) {
  const auto device = MakePluginDevice(Plugin("template"), 0.001);
  const auto at_rest = [](const DeviceState& state) {
    // 1 N on 50 N/m; a hundredth of it is far below and far above what rest and passing through at
    // speed would show.
    return std::abs(state.p_D.x - 0.020) < 2e-4 && glm::length(state.v_D) < 1e-4;
  };
  DeviceState state;
  EXPECT_TRUE(TickUntil(
      *device, {1, 0, 0}, [&](DeviceStatus) { return at_rest(state); }, &state));
  EXPECT_EQ(state.p_D.y, 0);
  EXPECT_TRUE(state.velocity_known);
}

TEST_F(PluginDeviceTest, NeverPassesOnMoreThanThePeakForceOrWhatIsNoNumber) {
  const auto device = MakePluginDevice(Plugin("none"), 0.001);
  const auto has = [](glm::dvec3 wished) {
    return [wished](const std::vector<glm::dvec3>& forces) {
      return !forces.empty() && forces.back() == wished;
    };
  };
  std::thread ticks([&device] {
    for (int n = 0; n < 300; ++n) {
      device->Write(n < 150 ? glm::dvec3(100, -100, 1) : glm::dvec3(0, 0, std::nan("")));
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  ticks.join();
  EXPECT_TRUE(ForcesBecome(has({0, 0, 0})));
  bool capped = false;
  for (const glm::dvec3& force : Forces()) {
    EXPECT_LE(std::max({std::abs(force.x), std::abs(force.y), std::abs(force.z)}), 3.0);
    capped = capped || force == glm::dvec3(3, -3, 1);
  }
  EXPECT_TRUE(capped);
}

TEST_F(PluginDeviceTest, GetsZeroAndAnEndWhenClosed) {
  {
    const auto device = MakePluginDevice(Plugin("none"), 0.001);
    TickUntil(*device, {1, 0, 0}, [](DeviceStatus s) { return s == DeviceStatus::kOk; });
  }
  EXPECT_TRUE(EndsWithZero(Forces()));
}

TEST_F(PluginDeviceTest, IsLostAfterANumberThatIsNone) {
  const auto device = MakePluginDevice(Plugin("nan_position"), 0.001);
  EXPECT_TRUE(TickUntilLost(*device, {1, 0, 0}));
  EXPECT_TRUE(ForcesBecome(EndsWithZero));
  DeviceState state;
  state.p_D.x = 7;
  EXPECT_EQ(device->Read(state), DeviceStatus::kLost);
  EXPECT_EQ(state.p_D.x, 7);
  EXPECT_EQ(device->Write({1, 0, 0}), DeviceStatus::kLost);
}

TEST_F(PluginDeviceTest, IsLostWhenThePluginSaysSo) {
  const auto device = MakePluginDevice(Plugin("lost"), 0.001);
  EXPECT_TRUE(TickUntilLost(*device, {1, 0, 0}));
  EXPECT_TRUE(ForcesBecome(EndsWithZero));
}

TEST_F(PluginDeviceTest, IsLostAfterAHangACrashAnExitAndAScribble) {
  for (const char* fault : {"hang", "crash", "exit", "scribble"}) {
    const auto device = MakePluginDevice(Plugin(fault), 0.001);
    EXPECT_TRUE(TickUntilLost(*device, {1, 0, 0})) << fault;
  }
}

TEST_F(PluginDeviceTest, TellsWhyItWasLost) {
  const std::pair<const char*, const char*> reasons[] = {
      {"hang", "the plug-in hung for 0.1 s"},
      {"crash", "the plug-in crashed (signal 11, Segmentation fault)"},
      {"exit", "the plug-in ended its process (code 3)"},
      {"nan_position", "the plug-in gave a position or velocity that is no number"},
      {"lost", "the plug-in lost its device"}};
  for (const auto& reason : reasons) {
    const auto device = MakePluginDevice(Plugin(reason.first), 0.001);
    EXPECT_EQ(device->WhyLost(), "");
    EXPECT_TRUE(TickUntilLost(*device, {1, 0, 0})) << reason.first;
    EXPECT_EQ(device->WhyLost(), reason.second);
  }
}

TEST_F(PluginDeviceTest, IsLostWithItsRealRateWhenItIsFarTooSlow) {
  const auto device = MakePluginDevice(Plugin("slow"), 0.001);
  ASSERT_TRUE(TickUntilLost(*device, {0, 0, 0}));
  // It promises 1000 rounds a second and takes 50 ms for each; a busy machine makes it no faster.
  const std::string why = device->WhyLost();
  EXPECT_NE(why.find("times a second, not 1000"), std::string::npos) << why;
  int rate = 0;
  ASSERT_EQ(std::sscanf(why.c_str(), "the plug-in reads and writes %d", &rate), 1) << why;
  EXPECT_LE(rate, 20);
  EXPECT_GE(rate, 5);
}

TEST_F(PluginDeviceTest, EndsWithWhatItHasStarted) {
  auto device = MakePluginDevice(Plugin("forks"), 0.001);
  ASSERT_TRUE(ForcesBecome([](const auto& forces) {
    return !forces.empty() && std::ranges::any_of(forces, [](auto f) { return f.x > 1; });
  }));
  pid_t started = 0;
  for (const glm::dvec3& force : Forces()) {
    if (force.x > 1) started = static_cast<pid_t>(force.x);
  }
  ASSERT_EQ(SignalChild(started, 0), 0);
  device.reset();
  const auto has_ended = [started] {  // whoever its parent is now may not have collected it yet
    std::ifstream file("/proc/" + std::to_string(started) + "/stat");
    std::string number, name, state;
    return !(file >> number >> name >> state) || state == "Z";
  };
  for (int tries = 0; tries < 10000 && !has_ended(); ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(has_ended());
}

TEST_F(PluginDeviceTest, CanBeOpenedAgainAfterACrash) {
  for (int n = 0; n < 3; ++n) {
    const auto device = MakePluginDevice(Plugin("crash"), 0.001);
    EXPECT_TRUE(TickUntil(*device, {}, [](DeviceStatus s) { return s == DeviceStatus::kOk; }));
    EXPECT_TRUE(TickUntilLost(*device, {}));
  }
}

TEST_F(PluginDeviceTest, TellsThatItsMotorsAreOff) {
  const auto device = MakePluginDevice(Plugin("not_ready"), 0.001);
  const auto not_ready = [](DeviceStatus s) { return s == DeviceStatus::kNotReady; };
  EXPECT_TRUE(TickUntil(*device, {}, not_ready));
  EXPECT_TRUE(TickUntil(*device, {}, [](DeviceStatus s) { return s == DeviceStatus::kOk; }));
}

TEST_F(PluginDeviceTest, GetsZeroWhenTheProgramFallsSilentAndForceWhenItGoesOn) {
  const auto device = MakePluginDevice(Plugin("none"), 0.001);
  const auto pushed = [](const std::vector<glm::dvec3>& forces) {
    return !forces.empty() && forces.back() == glm::dvec3(1, 0, 0);
  };
  const auto released = [&](const std::vector<glm::dvec3>& forces) {
    return !forces.empty() && forces.back() == glm::dvec3(0.0);
  };
  const auto keep_pushing = [&] {
    return TickUntil(*device, {1, 0, 0}, [&](DeviceStatus) { return pushed(Forces()); });
  };
  EXPECT_TRUE(keep_pushing());
  EXPECT_TRUE(ForcesBecome(released));
  EXPECT_TRUE(keep_pushing());
}

TEST_F(PluginDeviceTest, GetsZeroAndAnEndWhenTheProgramIsKilled) {
  const std::string plugin = Plugin("none");
  const ::pid_t program = fork();
  ASSERT_GE(program, 0);
  if (program == 0) {
    const auto device = MakePluginDevice(plugin, 0.001);
    TickUntil(*device, {1, 0, 0}, [](DeviceStatus) { return false; });
    _exit(0);
  }
  EXPECT_TRUE(ForcesBecome([](const std::vector<glm::dvec3>& forces) {
    return !forces.empty() && forces.back() == glm::dvec3(1, 0, 0);
  }));
  SignalChild(program, SIGKILL);
  waitpid(program, nullptr, 0);
  EXPECT_TRUE(ForcesBecome(EndsWithZero));
}

TEST_F(PluginDeviceTest, IsRefusedInOneLineWhenItCannotBeOpened) {
  EXPECT_TRUE(Has(Refusal("wrong_version"), "version 2")) << Refusal("wrong_version");
  EXPECT_TRUE(Has(Refusal("wrong_size"), "gives 8 as the size")) << Refusal("wrong_size");
  EXPECT_TRUE(Has(Refusal("crash_at_open"), "signal 6")) << Refusal("crash_at_open");
  EXPECT_TRUE(Has(Refusal("refuse"), "no arm found: plug it in")) << Refusal("refuse");
  EXPECT_TRUE(Has(Refusal("bad_description"), "workspace")) << Refusal("bad_description");
}

// One that fails in its first rounds may do so before its opening was noticed or after.
TEST_F(PluginDeviceTest, SaysWhatItDidWrongAtOnce) {
  const std::pair<const char*, const char*> reasons[] = {{"nan_at_once", "that is no number"},
                                                         {"code_at_once", "lost its device"}};
  for (const auto& [fault, why] : reasons) {
    std::string said;
    try {
      const auto device = MakePluginDevice(Plugin(fault), 0.001);
      EXPECT_TRUE(TickUntilLost(*device, {}));
      said = device->WhyLost();
    } catch (const DeviceError& error) {
      said = error.what();
    }
    EXPECT_TRUE(Has(said, why)) << said;
    EXPECT_TRUE(EndsWithZero(Forces())) << fault;
  }
}

TEST_F(PluginDeviceTest, RefusesWhatIsNoPlugin) {
  const std::filesystem::path path = folder / "text.so";
  std::ofstream(path) << "not a shared object\n";
  EXPECT_THROW(MakePluginDevice(path.string(), 0.001), DeviceError);
}

TEST(PluginHost, RefusesToBeStartedByHand) {
  const int status = std::system((PluginHostPath() + " 2>/dev/null").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 2);
}

TEST(PluginDescription, IsRefusedForFieldsThatCannotBe) {
  moontrace_description good = {};
  good.rate = 1000;
  for (double& edge : good.workspace) edge = 0.1;
  good.measures = 7;
  good.pushes = 3;
  good.peak_force = 3;
  good.stiffness = 500;
  EXPECT_EQ(ProfileOf(good, "x").limits.pushes, glm::bvec3(true, true, false));
  EXPECT_TRUE(std::isinf(ProfileOf(good, "x").limits.continuous_force));
  const auto refuses = [&good](void (*change)(moontrace_description&)) {
    moontrace_description bad = good;
    change(bad);
    EXPECT_THROW(ProfileOf(bad, "x"), DeviceError);
  };
  refuses([](moontrace_description& d) { d.rate = 0; });
  refuses([](moontrace_description& d) { d.peak_force = std::nan(""); });
  refuses([](moontrace_description& d) { d.peak_force = 0; });
  refuses([](moontrace_description& d) { d.workspace[2] = -1; });
  refuses([](moontrace_description& d) { d.measures = 4; });
  refuses([](moontrace_description& d) { d.pushes = 8; });
  refuses([](moontrace_description& d) { d.buttons = 33; });
  refuses([](moontrace_description& d) { d.stiffness = 0; });
  refuses([](moontrace_description& d) { d.continuous_force = 1; });
  refuses([](moontrace_description& d) {
    d.continuous_force = 4;
    d.heat_time = 20;
  });
}

}  // namespace
}  // namespace moontrace
