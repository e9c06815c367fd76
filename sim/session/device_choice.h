#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "devices/catalogue/catalogue.h"
#include "devices/core/device.h"
#include "sim/setup/options.h"

namespace moontrace {

/// What `--device` names: the simulated stylus unless another is given.
inline bool IsSimulated(const std::string& name) { return name.empty() || name == "simulated"; }

/// The mouse or pen in the window of the view.
inline bool IsMouse(const std::string& name) { return name == "mouse"; }

/// Opens any other device, homed, for ticks of `tick` [s] and, where it has no third axis, a press
/// of `press` [N]. `tell` gets what the person must hear; `patience` is OpenHomed's. Throws as
/// that.
std::unique_ptr<Device> OpenNamed(const std::string& name, double tick, double press,
                                  const std::function<void(std::string_view)>& tell,
                                  const std::atomic<bool>* stop,
                                  std::optional<double> patience = std::nullopt);

/// What moves the tip in real time, and how: `--device`, `--seconds`, `--rate-hz`, `--scale`,
/// `--hold-to-feel`.
struct LiveOptions {
  std::string device;             ///< as IsSimulated and OpenNamed take it
  std::optional<double> seconds;  ///< [s]
  std::optional<double> rate;     ///< [Hz]
  std::optional<double> scale;
  bool hold_to_feel = false;
};
void AddOptions(CLI::App& app, LiveOptions& options);

/// The first device with motors that can be opened; without such a one the first that has motors;
/// none: there is none.
std::optional<DeviceEntry> FirstForceDevice();

}  // namespace moontrace
