#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "devices/catalogue/catalogue.h"

namespace moontrace {

/// Opens a device ready to push. An arm that must be homed first is homed here: `tell` gets each
/// sentence that the person must hear. May block for as long as that takes, so it is for commands
/// and for the loop's reopening thread, never for the tick. `stop` may be null.
///
/// Throws DeviceError: as OpenDevice, lost meanwhile, or not homed within two minutes, within
/// `patience` [s] if that is less; Interrupted once `stop` is true.
std::unique_ptr<Device> OpenHomed(const DeviceRequest& request, const std::string& profiles,
                                  const std::function<void(std::string_view)>& tell,
                                  const std::atomic<bool>* stop,
                                  std::optional<double> patience = std::nullopt);

}  // namespace moontrace
