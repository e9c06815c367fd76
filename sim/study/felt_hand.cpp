#include "sim/study/felt_hand.h"

#include <algorithm>
#include <cmath>

#include "devices/core/tip_estimate.h"
#include "sim/trial/hand_on_device.h"

namespace moontrace {

FeltHand::FeltHand(const HandModel& hand, const SceneOptions& options, const DeviceProfile* device)
    : hand_(hand), scene_(Scene::Load("", options)), tick_(options.tick) {
  if (device == nullptr) return;
  device_ = *device;
  scene_.SetOptions(HeldOn(*device, options, scene_.proxy_mass()));
}

void FeltHand::Do(const Work& work, const std::function<void(const HandTick&)>& each) {
  scene_.SetField(work.field);
  const Pose X_WP = scene_.X_WP();
  HandOnDevice::Setup setup{hand_, work.path, tick_, work.seed};
  if (device_) setup.profile = &*device_;
  setup.press = 0;
  for (const HandPoint& point : work.path.points) setup.press = std::max(setup.press, point.press);
  HandOnDevice hand(setup, X_WP);
  const TextureField flat;
  const TextureField& field = work.field != nullptr ? *work.field : flat;
  scene_.Reset(FromWorld(X_WP, work.path.points.front().p_D));
  const double duration = work.path.points.back().time - work.path.points.front().time;
  const auto ticks = static_cast<std::size_t>(std::ceil(duration / tick_));
  GuidanceState state;
  TipEstimate velocity;
  TickResult output;
  for (std::size_t n = 0; n < ticks; ++n) {
    const DeviceState input = hand.Read(scene_, n > 0 ? &output : nullptr, field);
    output = scene_.Tick(input);
    HandTick now;
    now.time = input.time;
    now.tip_P = output.tip_P;
    now.in_contact = output.depth > 0;
    if (work.push != nullptr) {
      velocity.Advance(tick_, true, output.tip_P);
      const glm::dvec3 v_P = output.velocity_known ? output.v_P : velocity.v();
      now.guidance_P = Guide(*work.push, state, output.tip_P, v_P, tick_).force_P;
    }
    now.force_P = output.force_P + now.guidance_P;
    hand.Write(output.force_W + TurnToWorld(X_WP, now.guidance_P), output.stored);
    each(now);
  }
  seconds_ += static_cast<double>(ticks) * tick_;
  scene_.SetField(nullptr);
}

}  // namespace moontrace
