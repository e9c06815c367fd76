#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/app/program_help.h"

/// What other programs of the machine want to know of this one, from the same source as its help.
namespace moontrace {

/// The manual page moontrace(1) in the language of man(7). Options that several commands take alike
/// stand once.
std::string Manual(const std::vector<CommandCard>& cards, const std::vector<CommandSheet>& sheets,
                   std::string_view version);

/// A script by which bash completes commands, their options, and names of files.
std::string BashCompletion(const std::vector<std::string>& words,
                           const std::vector<CommandSheet>& sheets);

}  // namespace moontrace
