#pragma once

#include <string>

/// What the demonstration answers to words; what it tells stands in lessons/demonstration.toml.
namespace moontrace::say {

std::string DemonstrationHelp();
std::string DemonstrationPauses();
std::string DemonstrationGoesOn();
std::string DemonstrationSlower();

}  // namespace moontrace::say
