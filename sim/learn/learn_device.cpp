#include "sim/learn/learn_device.h"

#include <glm/glm.hpp>

#include "devices/catalogue/catalogue.h"
#include "sim/learn/learn_messages.h"
#include "textures/base/error.h"

namespace moontrace {

std::string DeviceForLearning(const std::string& named, Console& console) {
  if (!named.empty()) return named;
  std::string problem;
  for (const DeviceEntry& entry : ListDevices(ProfilesFolder())) {
    if (!glm::any(entry.profile.limits.pushes)) continue;
    if (entry.problem.empty()) return entry.name;
    if (problem.empty()) problem = say::DeviceProblem(entry.name, entry.problem);
  }
  console.Result(say::NoForceDevice());
  if (!problem.empty()) console.Result(problem);
  for (const std::string& line : say::LearningWithoutDevice()) console.Result(line);
  throw LackError(say::NoDeviceGiven());
}

}  // namespace moontrace
