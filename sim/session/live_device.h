#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "devices/core/device.h"
#include "devices/hand/hand.h"
#include "sim/console/console.h"
#include "sim/loop/loop.h"
#include "sim/physics/pose.h"
#include "sim/session/felt_page.h"
#include "sim/session/session_request.h"

namespace moontrace {

/// A simulated hand that goes through a page again and again.
struct HandOnPage {
  std::unique_ptr<Device> device;
  double round = 0;  ///< how long it takes for the page once [s]
};

/// What moves the tip in real time, as `--device` names it: a device of the catalogue, the mouse in
/// the window of a view, or the simulated hand. One thread, but for what Reopening gives.
class LiveDevice {
 public:
  /// Opens it; the simulated hand comes with its pages (HandOn). `console` gets what must be heard
  /// meanwhile. Throws DeviceError and Interrupted as OpenNamed; UsageError: a mouse without a
  /// window, a scale without a device that could have one; LackError: no hand is installed.
  LiveDevice(const SessionRequest& request, Console& console);

  /// As IsSimulated and OpenNamed take it.
  const std::string& name() const { return name_; }
  bool simulated() const { return simulated_; }
  /// A mouse moves the tip, in the page's plane, and nothing can be felt of it.
  bool mouse() const { return mouse_; }
  /// Those of no device, without any bound, for the simulated hand.
  const DeviceLimits& limits() const { return limits_; }
  /// What pushes this is felt, by a hand or by the simulated one.
  bool pushes() const;
  /// A person's hand is pushed.
  bool felt() const { return !simulated_ && pushes(); }
  double scale() const { return scale_; }  ///< see DevicePlace
  double press() const;                    ///< of what has no third axis [N]
  /// How much page it can reach [m]; infinite where nothing bounds it.
  glm::dvec2 room() const;
  /// Where it stands to a page whose pose is `X_WP`; one that is laid on the page wants the pose
  /// that P itself has in P. The page lies in the middle of what it reaches; for one that reaches
  /// everywhere, its origin is where the text begins.
  DevicePlace PlaceOn(const Typeset& set, const Pose& X_WP) const;

  /// What was opened, once; nullptr for the simulated hand.
  std::unique_ptr<Device> Take() { return std::move(opened_); }
  /// Its frame is laid on the page, see LoopOptions::on_page.
  bool on_page() const { return simulated_ || mouse_ || !limits_.measures.z; }
  /// The simulated hand on a page, in its frame P, from its beginning.
  HandOnPage HandOn(const FeltPage& page) const;
  /// Opens it again after it was lost, see Loop. This must outlive what is given.
  DeviceSource Reopening();
  /// What opening it again had to say, since the last call. Any thread.
  std::vector<std::string> TakeSentences();

 private:
  std::string name_;
  bool simulated_ = true, mouse_ = false;
  double scale_ = 1;
  double tick_ = 0.001;  ///< [s]
  std::optional<double> press_;
  std::uint64_t seed_ = 1;
  DeviceLimits limits_;
  HandModel hand_;  ///< of a simulated hand, and of the one that a mouse leads
  std::unique_ptr<Device> opened_;
  std::mutex sentences_mutex_;
  std::vector<std::string> sentences_;
};

}  // namespace moontrace
