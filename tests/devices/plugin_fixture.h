#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <thread>
#include <vector>

#include "devices/core/device.h"

namespace moontrace {

/// A folder that only this user can write, wherever the tests were built, for plug-ins and what
/// they write.
class PluginTest : public testing::Test {
 protected:
  PluginTest() {
    std::string name = (std::filesystem::temp_directory_path() / "moontrace-XXXXXX").string();
    folder = mkdtemp(name.data());
    forces_file = folder / "forces";
    setenv("MOONTRACE_TEST_FORCES", forces_file.c_str(), 1);
  }
  ~PluginTest() override {
    unsetenv("MOONTRACE_TEST_FORCES");
    std::filesystem::remove_all(folder);
  }

  /// The test's own copy of a plug-in that the build made.
  std::string Plugin(const std::string& name) const {
    const std::filesystem::path to = folder / (name + ".so");
    const auto built = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "plugins";
    std::filesystem::copy_file(built / (name + ".so"), to,
                               std::filesystem::copy_options::overwrite_existing);
    std::filesystem::permissions(to, std::filesystem::perms(0755));
    return to.string();
  }

  /// Ticks once a millisecond with a force until the status is reached, 10 s at most.
  static bool TickUntil(Device& device, glm::dvec3 f_D,
                        const std::function<bool(DeviceStatus)>& end, DeviceState* last = nullptr) {
    DeviceState state;
    for (int tick = 0; tick < 10000; ++tick) {
      const DeviceStatus status = device.Read(state);
      device.Write(f_D);
      if (last != nullptr) *last = state;
      if (end(status)) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  }
  static bool TickUntilLost(Device& device, glm::dvec3 f_D) {
    return TickUntil(device, f_D, [](DeviceStatus s) { return s == DeviceStatus::kLost; });
  }

  /// What the plug-in was told to push with, one after the other; after its orderly end (-1,-1,-1).
  std::vector<glm::dvec3> Forces() const {
    std::ifstream file(forces_file, std::ios::binary);
    std::vector<glm::dvec3> forces;
    glm::dvec3 force(0.0);
    while (file.read(reinterpret_cast<char*>(&force), sizeof force)) forces.push_back(force);
    return forces;
  }
  /// Waits until what was written so far is as wished, 10 s at most.
  bool ForcesBecome(const std::function<bool(const std::vector<glm::dvec3>&)>& wished) const {
    for (int tries = 0; tries < 1000; ++tries) {
      if (wished(Forces())) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  std::filesystem::path folder;
  std::filesystem::path forces_file;
};

inline const glm::dvec3 kOrderlyEnd(-1.0, -1.0, -1.0);

/// Zero was commanded, then the device closed.
inline bool EndsWithZero(const std::vector<glm::dvec3>& forces) {
  return forces.size() >= 2 && forces.back() == kOrderlyEnd &&
         forces[forces.size() - 2] == glm::dvec3(0.0);
}

}  // namespace moontrace
