#pragma once

#include <string>
#include <string_view>

/// What the demonstration answers to words; what it tells stands in lessons/demonstration.toml.
namespace moontrace::say {

std::string DemonstrationHelp();
std::string DemonstrationPauses();
std::string DemonstrationGoesOn();
std::string DemonstrationSlower();
std::string DemonstrationUnknown(std::string_view given);

}  // namespace moontrace::say
