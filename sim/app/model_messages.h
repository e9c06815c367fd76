#pragma once

#include <string>
#include <string_view>

/// Sentences about text on a geom of a model; see messages.h.
namespace moontrace::say {

std::string PageMoves(std::string_view geom);

}  // namespace moontrace::say
