#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "devices/device.h"

namespace moontrace {

enum class DeviceKind { kPid, kWoodenHaptics, kRawHid, kPuck, kPlugin };

/// What is known of a device beforehand: `devices/profiles/NAME.toml`.
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
  double delay = 0.001;         ///< from force to motion and back, beside one period [s]
  double position_step = 0;     ///< resolution [m]
  double force_step = 0;        ///< resolution [N]
  double coulomb_friction = 0;  ///< f_c [N]
  double velocity_cutoff = 0;   ///< of the velocity filter [Hz]; 0: none
};

/// Reads a profile. Throws DeviceError with file:line:column.
DeviceProfile LoadProfile(const std::string& path);
DeviceProfile ParseProfile(std::string_view text, const std::string& name);

/// Greatest virtual stiffness a device renders without buzzing [N/m]: the least of 2 b / T, 2 f_c /
/// step and the maker's figure, T being a period and the delay (mujoco-and-hid reference;
/// Abbott and Okamura 2005; Diolaiti et al. 2006). Terms whose data are unknown (0) do not count.
double StableStiffness(const DeviceProfile& profile);

/// The limits a loop needs, with `stiffness` the stable one and `late_ticks` from delay and rate.
DeviceLimits LimitsOf(const DeviceProfile& profile, double tick);

}  // namespace moontrace
