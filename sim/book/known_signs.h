#pragma once

#include <string>

namespace moontrace {

/// The signs that a learner has been taught in the course that is shipped, as `--only` takes them.
/// `records`: path of the file; `learner`: empty means the only one in it. Throws UsageError:
/// nobody is named, and there are none or several; InputError: no sign was taught yet, or the file
/// cannot be read; LackError: built without records.
std::string KnownSigns(const std::string& records, const std::string& learner);

}  // namespace moontrace
