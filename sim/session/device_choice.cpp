#include "sim/session/device_choice.h"

#include <glm/glm.hpp>

#include "devices/catalogue/catalogue.h"
#include "sim/loop/pacing.h"
#include "sim/session/device_opening.h"
#include "sim/session/loop_messages.h"
#include "sim/setup/help.h"

namespace moontrace {

std::unique_ptr<Device> OpenNamed(const std::string& name, double tick, double press,
                                  const std::function<void(std::string_view)>& tell,
                                  const std::atomic<bool>* stop, std::optional<double> patience) {
  std::string remark;
  DeviceRequest request;
  request.name = name;
  request.tick = tick;
  request.press = press;
  request.remark = &remark;
  std::unique_ptr<Device> device = OpenHomed(request, ProfilesFolder(), tell, stop, patience);
  if (!remark.empty()) tell(remark);
  return device;
}

std::optional<DeviceEntry> FirstForceDevice() {
  std::optional<DeviceEntry> first;
  for (DeviceEntry& entry : ListDevices(ProfilesFolder())) {
    if (!glm::any(entry.profile.limits.pushes)) continue;
    if (entry.problem.empty()) return std::move(entry);
    if (!first) first = std::move(entry);
  }
  return first;
}

void AddOptions(CLI::App& app, LiveOptions& options) {
  BeginGroup(app, help_group::kDevice);
  AddPath(app, "--device", "NAME", options.device, say::help::kDevice);
  AddNumber(app, "--seconds", options.seconds, 0.01, 1e6, 1, say::help::kSeconds);
  AddNumber(app, "--rate-hz", options.rate, kSlowestRate, kFastestRate, 1, say::help::kRate);
  AddNumber(app, "--scale", options.scale, 0.1, 10, 1, say::help::kScale);
  AddFlag(app, "--hold-to-feel", options.hold_to_feel, say::help::kHoldToFeel);
}

}  // namespace moontrace
