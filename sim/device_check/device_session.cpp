#include "sim/device_check/device_session.h"

#include <algorithm>
#include <glm/glm.hpp>

#include "sim/loop/pacing.h"

namespace moontrace {

namespace {

constexpr double kTick = 1e-3;  // [s]

DeviceLimits WithCap(DeviceLimits limits, double cap) {
  limits.peak_force = std::min(limits.peak_force, cap);
  return limits;
}

void See(SessionView& view, const DeviceState& state) {
  if (view.reports == 0) view.low_D = view.high_D = view.first_D = state.p_D;
  ++view.reports;
  view.low_D = glm::min(view.low_D, state.p_D);
  view.high_D = glm::max(view.high_D, state.p_D);
  view.last_D = state.p_D;
  view.buttons |= state.buttons;
}

/// Leaves the device with zero force, whatever ends a run.
class Release {
 public:
  explicit Release(Device& device) : device_(device) {}
  ~Release() { device_.Write(glm::dvec3(0.0)); }
  Release(const Release&) = delete;
  Release& operator=(const Release&) = delete;

 private:
  Device& device_;
};

}  // namespace

DeviceSession::DeviceSession(Device& device, double force_cap, Clock& clock)
    : device_(device), clock_(clock), safety_(WithCap(device.Limits(), force_cap), kTick) {}

SessionView DeviceSession::Run(double seconds, glm::dvec3 f_D, const Console& console) {
  const Release release(device_);
  Pacing pacing(clock_, 1 / kTick);
  SessionView view;
  SafetyInput input;
  input.ramp = true;
  // Whatever is no number counts as a push too.
  const bool pushes = !(glm::length(f_D) == 0);
  const std::int64_t begin = clock_.Now();
  while (view.time < seconds && !view.lost && !view.stopped) {
    console.CheckStop();
    const std::int64_t now = pacing.Wait().time;
    view.time = 1e-9 * static_cast<double>(now - begin);
    input.time = 1e-9 * static_cast<double>(now);
    input.status = device_.Read(newest_);
    input.device = newest_;
    if (input.status == DeviceStatus::kOk) See(view, newest_);
    view.lost = input.status == DeviceStatus::kLost;
    view.not_ready = view.not_ready || input.status == DeviceStatus::kNotReady;
    view.stopped = pushes && newest_.buttons != 0;
    input.force = view.stopped ? glm::dvec3(0.0) : f_D;
    const SafetyResult result = safety_.Advance(input);
    input.ramp = false;
    if (device_.Write(result.force) == DeviceStatus::kLost) view.lost = true;
    view.events |= result.events;
    view.greatest_force = glm::max(view.greatest_force, glm::abs(result.force));
  }
  return view;
}

}  // namespace moontrace
