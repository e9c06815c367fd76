#include "devices/plugin/plugin_device.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "devices/core/device_error.h"
#include "devices/plugin/plugin_process.h"

namespace moontrace {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A number of the description with the range in which it can be meant.
struct Field {
  const char* name;
  double moontrace_description::*member;
  double least;
  double most;
};
constexpr Field kFields[] = {
    {"rate", &moontrace_description::rate, 100, 10000},
    {"peak_force", &moontrace_description::peak_force, 0, 100},
    {"continuous_force", &moontrace_description::continuous_force, 0, 100},
    {"heat_time", &moontrace_description::heat_time, 0, 1e5},
    {"peak_power", &moontrace_description::peak_power, 0, 1e4},
    {"stiffness", &moontrace_description::stiffness, 0, 1e5},
    {"damping", &moontrace_description::damping, 0, 1e3},
    {"coulomb_friction", &moontrace_description::coulomb_friction, 0, 100},
    {"position_step", &moontrace_description::position_step, 0, 0.1},
    {"force_step", &moontrace_description::force_step, 0, 100},
    {"delay", &moontrace_description::delay, 0, 1},
    {"dead_man", &moontrace_description::dead_man, 0, 1e4},
};

[[noreturn]] void Refuse(const std::string& path, const std::string& what) {
  throw DeviceError(fmt::format("plug-in {}: {}: correct it in describe", path, what));
}

void Check(const moontrace_description& d, const std::string& path) {
  for (const Field& field : kFields) {
    const double value = d.*field.member;
    if (!(value >= field.least && value <= field.most)) {
      Refuse(path, fmt::format("{} is not from {} to {}", field.name, field.least, field.most));
    }
  }
  for (const double edge : d.workspace) {
    if (!(edge > 0 && edge <= 10)) Refuse(path, "workspace is not above 0 up to 10 m");
  }
  if ((d.measures & 3u) != 3u || d.measures > 7) Refuse(path, "measures lacks x or y");
  if (d.pushes > 7) Refuse(path, "pushes has bits beyond x, y and z");
  if (d.buttons > 32) Refuse(path, "buttons is more than 32");
  if (d.pushes != 0 && (d.peak_force <= 0 || (d.stiffness <= 0 && d.damping <= 0))) {
    Refuse(path, "it pushes without peak_force, or without stiffness and damping");
  }
  if (d.continuous_force > d.peak_force) Refuse(path, "continuous_force is above peak_force");
  if (d.continuous_force > 0 && d.heat_time <= 0) Refuse(path, "heat_time is missing");
}

std::string TitleOf(const moontrace_description& d) {
  std::string title;
  for (const char c : d.title) {
    if (c == '\0') break;
    const auto byte = static_cast<unsigned char>(c);
    title += byte < 0x20 || byte == 0x7f ? '?' : c;
  }
  return title.empty() ? "plug-in without a title" : title;
}

double OrInfinity(double value) { return value > 0 ? value : kInfinity; }

class PluginDevice final : public Device {
 public:
  PluginDevice(const std::string& path, double tick) : process_(PluginHostPath(), path) {
    profile_ = ProfileOf(process_.description(), path);
    limits_ = LimitsOf(profile_, tick);
  }
  ~PluginDevice() override { process_.Put({}); }

  DeviceLimits Limits() const noexcept override { return limits_; }

  DeviceStatus Read(DeviceState& state) noexcept override {
    if (lost_ || !process_.IsAlive()) return Lost();
    plugin_wire::Reading got;
    if (!process_.Take(got)) return ready_ ? DeviceStatus::kNoNewData : DeviceStatus::kNotReady;
    ready_ = got.status == MOONTRACE_OK;
    if (!ready_) return DeviceStatus::kNotReady;
    const glm::dvec3 p_D(got.position[0], got.position[1], got.position[2]);
    const glm::dvec3 v_D(got.velocity[0], got.velocity[1], got.velocity[2]);
    // The helper has looked at them; its memory may have been scribbled over since.
    if (!std::isfinite(p_D.x + p_D.y + p_D.z) ||
        (got.velocity_known != 0 && !std::isfinite(v_D.x + v_D.y + v_D.z))) {
      return Lost();
    }
    state.time = got.time;
    state.p_D = p_D;
    state.velocity_known = got.velocity_known != 0;
    state.v_D = state.velocity_known ? v_D : glm::dvec3(0.0);
    state.buttons = got.buttons;
    return DeviceStatus::kOk;
  }

  DeviceStatus Write(glm::dvec3 f_D) noexcept override {
    if (lost_ || !process_.IsAlive()) return Lost();
    plugin_wire::Command command;
    if (std::isfinite(f_D.x) && std::isfinite(f_D.y) && std::isfinite(f_D.z)) {
      command.force = {f_D.x, f_D.y, f_D.z};
    }
    process_.Put(command);
    return ready_ ? DeviceStatus::kOk : DeviceStatus::kNotReady;
  }

  std::string WhyLost() override {
    if (!lost_) return {};
    const std::string how = process_.HowItEnded();
    return "the plug-in " + (how.empty() ? "gave a position that is no number" : how);
  }

  const DeviceProfile& profile() const noexcept { return profile_; }

 private:
  DeviceStatus Lost() noexcept {
    if (!lost_) process_.Put({});
    lost_ = true;
    return DeviceStatus::kLost;
  }

  PluginProcess process_;
  DeviceProfile profile_;
  DeviceLimits limits_;
  bool lost_ = false;
  bool ready_ = true;
};

}  // namespace

DeviceProfile ProfileOf(const moontrace_description& description, const std::string& path) {
  const moontrace_description& d = description;
  Check(d, path);
  DeviceProfile profile;
  profile.name = "plugin:" + path;
  profile.title = TitleOf(d);
  profile.kind = DeviceKind::kPlugin;
  profile.rate = d.rate;
  profile.delay = d.delay;
  profile.position_step = d.position_step;
  profile.force_step = d.force_step;
  profile.coulomb_friction = d.coulomb_friction;
  DeviceLimits& limits = profile.limits;
  limits.peak_force = d.peak_force;
  limits.continuous_force = OrInfinity(d.continuous_force);
  limits.heat_time = d.heat_time;
  limits.peak_power = OrInfinity(d.peak_power);
  limits.stiffness = OrInfinity(d.stiffness);
  limits.damping = d.damping;
  limits.dead_man = d.dead_man;
  limits.buttons = static_cast<int>(d.buttons);
  for (int i = 0; i < 3; ++i) {
    limits.measures[i] = ((d.measures >> i) & 1u) != 0;
    limits.pushes[i] = ((d.pushes >> i) & 1u) != 0;
    limits.workspace_D[i] = d.workspace[i];
  }
  if (d.pushes == 0) limits.stiffness = 0;
  return profile;
}

std::unique_ptr<Device> MakePluginDevice(const std::string& path, double tick) {
  return std::make_unique<PluginDevice>(path, tick);
}

DeviceProfile DescribePlugin(const std::string& path) {
  return PluginDevice(path, 0.001).profile();
}

}  // namespace moontrace
