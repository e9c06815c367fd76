#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Sentences of `gallery`; part of the catalogue (messages.h).
namespace moontrace::say {

std::string GalleryOutcome(std::size_t drawn, std::size_t missing);
std::string ExhibitMissing(std::string_view title, std::string_view why);
std::string ExhibitFailed(std::string_view title, std::string_view why);

}  // namespace moontrace::say
