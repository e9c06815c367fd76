#include "sim/session/device_opening.h"

#include <chrono>

#include "devices/core/device_error.h"
#include "devices/hid/homing.h"
#include "sim/console/console.h"

namespace moontrace {

std::unique_ptr<Device> OpenHomed(const DeviceRequest& request, const std::string& profiles,
                                  const std::function<void(std::string_view)>& tell,
                                  const std::atomic<bool>* stop) {
  constexpr std::chrono::minutes kPatience(2);
  std::unique_ptr<Device> device = OpenDevice(request, profiles);
  const auto end = std::chrono::steady_clock::now() + kPatience;
  const auto is_stopped = [stop] { return stop != nullptr && stop->load(); };
  const bool is_homed = Home(
      *device,
      [&tell](HomingStep step) {
        if (step != HomingStep::kDone) tell(SentenceOf(step));
      },
      [&] { return !is_stopped() && std::chrono::steady_clock::now() < end; });
  if (is_stopped()) throw Interrupted();
  if (!is_homed) {
    throw DeviceError(request.name + ": was not put in its rest: plug it in and try again");
  }
  return device;
}

}  // namespace moontrace
