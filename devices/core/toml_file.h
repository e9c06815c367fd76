#pragma once

#include <string>

namespace moontrace {

/// The text of a TOML file of at most 1 MB. Throws DeviceError: it cannot be read or is longer;
/// `whose` ("a device's") completes the cure: "name a device's TOML file".
std::string ReadTomlFile(const std::string& path, const char* whose);

}  // namespace moontrace
