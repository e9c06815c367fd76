#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "devices/core/device.h"

namespace moontrace {

enum class DeviceKind { kPid, kWoodenHaptics, kRawHid, kPuck, kPlugin };

/// One axis of a device as one axis of frame D.
struct AxisMap {
  std::uint16_t usage = 0;  ///< HID usage of the generic desktop page, 0x30 X to 0x38 wheel
  double sign = 1;          ///< -1: it grows in the opposite direction
};

/// kPid: how a stick becomes the tip, and what presses the tip onto the page.
struct StickMap {
  enum class Press { kSetting, kButton, kAxis };
  AxisMap right{0x30, 1};  ///< x of frame D
  AxisMap away{0x31, -1};  ///< y of frame D: HID's Y grows towards the person
  /// Force at the tip at the greatest magnitude [N]. If it is unknown, a value too high is safer:
  /// the true force is then below the wanted one. Each axis, from end to end, spans the workspace.
  double full_force = 10;
  Press press = Press::kSetting;
  int press_button = 0;         ///< kButton: presses while held; 0 is the first
  AxisMap press_axis{0x36, 1};  ///< kAxis: its least is no press, its greatest the full one
};

/// kWoodenHaptics: three bodies A (turns about the upright), B and C (swing in the plane that A has
/// turned), each driven through a capstan by a motor with an encoder. Maker's frame M: x from the
/// base towards the person, y to the right, z up.
struct ArmGeometry {
  std::array<double, 3> link{};            ///< base to shoulder, body B, body C [m]
  std::array<double, 3> reduction{};       ///< turns of the motor for one of the body
  std::array<double, 3> counts{};          ///< encoder counts for one turn of the motor
  std::array<double, 3> encoder_sign{};    ///< of the body's angle as counts grow
  std::array<double, 3> current_sign{};    ///< of the body's torque as the current grows
  std::array<double, 3> motor_constant{};  ///< [N m/A]
  double peak_current = 0;                 ///< [A]
  glm::dvec3 origin_M{0, 0, 0};            ///< middle of the workspace [m]
  std::array<double, 3> rest{};            ///< angles of A, B, C in which it is homed [rad]
  std::size_t report_bytes = 8;            ///< of its input report; differs between the generations
};

/// kPuck: how a deflected puck moves the tip.
struct PuckMap {
  double full_scale = 350;  ///< greatest count of an axis
  double dead_zone = 0;     ///< counts that are rest
  double top_speed = 0;     ///< of the tip at full deflection [m/s]
  /// Which of the puck's translations (0, 1, 2) moves x, y, z of frame D, and in which direction.
  std::array<int, 3> axis{0, 1, 2};
  std::array<double, 3> sign{1, 1, 1};
};

/// What is known of a device in advance: `devices/profiles/NAME.toml`.
struct DeviceProfile {
  std::string name;   ///< of the file, what `--device` takes
  std::string title;  ///< for people
  DeviceKind kind = DeviceKind::kPid;
  struct Id {
    std::uint16_t vendor = 0, product = 0;
    bool own = true;  ///< false: a generic board's id, for which no udev rule is installed
  };
  std::vector<Id> ids;          ///< empty: recognised by its descriptor
  DeviceLimits limits;          ///< `stiffness` is the maker's figure here, see StableStiffness
  double rate = 1000;           ///< updates a second of all its forces [Hz]
  double delay = 0.001;         ///< from force to motion and back, on top of one period [s]
  double position_step = 0;     ///< resolution [m]
  double force_step = 0;        ///< resolution [N]
  double coulomb_friction = 0;  ///< f_c [N]
  double velocity_cutoff = 0;   ///< of the velocity filter [Hz]; 0: none
  double read_size = 0;         ///< the simulated reader reads letters from this on [m]; 0: untried
  StickMap stick;               ///< kPid
  ArmGeometry arm;              ///< kWoodenHaptics
  PuckMap puck;                 ///< kPuck
};

/// Reads a profile. Throws DeviceError with file:line:column, for an unknown key the nearest one.
/// Keys carry their unit; CONTRIBUTING.md lists them.
DeviceProfile LoadProfile(const std::string& path);
DeviceProfile ParseProfile(std::string_view text, const std::string& name);

/// Greatest virtual stiffness a device renders without buzzing [N/m]: the least of 2 b / T, 2 f_c /
/// step and the maker's figure, T being a period and twice the delay: a force held for a period is
/// half of it late on average, and the delay adds to that (Colgate and Schenkel 1994; Abbott and
/// Okamura 2005; `bench --stability` finds the same limit by simulation). Terms whose data are
/// unknown (0) do not count.
double StableStiffness(const DeviceProfile& profile);

/// The virtual coupling that a device gets.
struct CouplingGains {
  double stiffness = 0;  ///< [N/m]
  double damping = 0;    ///< [N s/m]
};
/// Spring and damper through which the page is felt on a device: as stiff as StableStiffness, but
/// no stiffer than 2000 N/m (1000 where nobody gave a figure), than a step of the readings allows
/// without grit, and than leaves a CouplingMargin of 1.5; damped for a proxy of 50 g
/// (models/proxy.xml), less where the readings are coarse or slow. Zeros for a stiffness of
/// 0. Ours, by measurement (`bench --stability`); see the source.
CouplingGains CouplingOf(const DeviceProfile& profile);

/// The limits a loop needs, with `stiffness` the stable one, the coupling of CouplingOf, and
/// `late_ticks` the whole ticks of `tick` [s] by which the force's period and the delay outlast the
/// tick it is computed in; at least one, since a force written in a tick is felt in the next.
/// `still` is the time of silence, at least 0.25 s.
DeviceLimits LimitsOf(const DeviceProfile& profile, double tick);

}  // namespace moontrace
