#include "sim/app/device_choice.h"

#include "sim/app/device_opening.h"
#include "sim/app/devices_command.h"
#include "sim/app/loop_messages.h"

namespace moontrace {

std::unique_ptr<Device> OpenNamed(const std::string& name, double tick, double press,
                                  const std::function<void(std::string_view)>& tell,
                                  const std::atomic<bool>* stop) {
  std::string remark;
  DeviceRequest request;
  request.name = name;
  request.tick = tick;
  request.press = press;
  request.remark = &remark;
  std::unique_ptr<Device> device = OpenHomed(request, ProfilesFolder(), tell, stop);
  if (!remark.empty()) tell(remark);
  return device;
}

void AddDevice(CLI::App& app, std::string& name) {
  AddPath(app, "--device", "NAME", name, say::help::kDevice);
}

}  // namespace moontrace
