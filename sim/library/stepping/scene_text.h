#pragma once

#include "sim/library/moontrace.h"
#include "sim/setup/text_setup.h"

namespace moontrace {

/// A style of the C interface as the command line has it: what is zero is as the label asks for.
/// Throws UsageError, InputError: a sheet or a word that is not known.
void SetStyle(const moontrace_style& given, TextRequest& request);

}  // namespace moontrace
