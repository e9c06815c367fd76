#include "sim/session/device_opening.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>

#include "devices/core/device_error.h"
#include "devices/hid/homing.h"
#include "sim/console/console.h"

namespace moontrace {

std::unique_ptr<Device> OpenHomed(const DeviceRequest& request, const std::string& profiles,
                                  const std::function<void(std::string_view)>& tell,
                                  const std::atomic<bool>* stop, std::optional<double> patience) {
  constexpr double kPatience = 120;  // [s]
  const double longest = std::min(patience.value_or(kPatience), kPatience);
  std::unique_ptr<Device> device = OpenDevice(request, profiles);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(longest);
  const auto is_stopped = [stop] { return stop != nullptr && stop->load(); };
  const bool is_homed = Home(
      *device,
      [&tell](HomingStep step) {
        if (step != HomingStep::kDone) tell(SentenceOf(step));
      },
      [&] { return !is_stopped() && std::chrono::steady_clock::now() < end; });
  if (is_stopped()) throw Interrupted();
  const bool in_time = std::chrono::steady_clock::now() < end;
  if (!is_homed && in_time) {
    throw DeviceError(fmt::format(
        "{}: was lost before it lay in its rest: look at its plug and its power", request.name));
  }
  if (!is_homed) {
    throw DeviceError(
        fmt::format("{}: was not put in its rest within {} s: begin again, and move the arm a "
                    "little, lay it in its rest, hold it still for a second",
                    request.name, longest));
  }
  return device;
}

}  // namespace moontrace
