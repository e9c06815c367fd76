#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>

#include "devices/core/device.h"
#include "devices/hid/wooden_haptics.h"

namespace moontrace {

/// What the person is asked to do before an arm without absolute encoders may push.
enum class HomingStep : std::uint8_t {
  kRest,  ///< move it a little, then hold it still in its rest for a second
  kMove,  ///< lift it, to the right and towards the person: the encoders' sense is checked
  kWrongDirection,  ///< it moved in another direction: as kRest, after saying so
  kDone,
};

/// What to say; one line of at most 80 columns. Empty for kDone.
std::string_view SentenceOf(HomingStep step);

/// Finds the rest position from encoder counts; pure. An arm that just lies somewhere is not taken
/// to be at rest: it must have been moved before, which shows that a person is there.
class Homing {
 public:
  static constexpr double kStillTime = 1;    ///< [s]
  static constexpr int kStill = 16;          ///< counts within which a hand trembles, about 1 mm
  static constexpr int kMoved = 200;         ///< counts that are a motion, about 1 cm
  static constexpr double kChecked = 0.015;  ///< travel along each axis that shows the sense [m]

  explicit Homing(const ArmGeometry& arm) : arm_(arm) {}
  /// The counts at `time` [s], ascending.
  HomingStep Advance(const ArmCounts& counts, double time) noexcept;
  /// To be homed again.
  void Reset() noexcept;

  HomingStep step() const noexcept { return step_; }
  const ArmCounts& rest() const noexcept { return rest_; }  ///< valid from kMove on

 private:
  void SeekRest(const ArmCounts& counts, double time) noexcept;
  void CheckSense(const ArmCounts& counts) noexcept;

  const ArmGeometry arm_;
  HomingStep step_ = HomingStep::kRest;
  ArmCounts rest_{}, first_{}, still_{};
  double still_since_ = 0;
  bool has_counts_ = false, has_moved_ = false;
  std::array<bool, 3> is_checked_{};
};

/// Second interface of a device that needs homing (dynamic_cast from Device). Until kDone its Read
/// says kNotReady, and again if its angles become impossible. Read and Write drive the homing; the
/// caller only has to say SentenceOf(NextStep()) when it changes. Commands and the loop's reopening
/// thread use OpenHomed (sim/session/device_opening.h).
class NeedsHoming {
 public:
  virtual ~NeedsHoming() = default;
  /// Any thread.
  virtual HomingStep NextStep() const noexcept = 0;
};

/// For commands, before the loop: ticks the device without force until it is homed, calling `say`
/// for each new step. At once true for devices that need no homing. False: lost, or `go_on`
/// returned false (it is asked every tick; a time limit or an interruption).
bool Home(Device& device, const std::function<void(HomingStep)>& say,
          const std::function<bool()>& go_on);

}  // namespace moontrace
