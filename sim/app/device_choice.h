#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "devices/device.h"
#include "sim/app/options.h"

namespace moontrace {

/// What `--device` names: the simulated stylus unless another is given.
inline bool IsSimulated(const std::string& name) { return name.empty() || name == "simulated"; }

/// Opens any other device, homed, for ticks of `tick` [s] and, where it has no third axis, a press
/// of `press` [N]. `tell` gets what the person must hear. Throws as OpenHomed.
std::unique_ptr<Device> OpenNamed(const std::string& name, double tick, double press,
                                  const std::function<void(std::string_view)>& tell,
                                  const std::atomic<bool>* stop);

/// `--device NAME`.
void AddDevice(CLI::App& app, std::string& name);

}  // namespace moontrace
