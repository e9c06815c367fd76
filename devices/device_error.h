#pragma once

#include <stdexcept>

namespace moontrace {

/// A device that is not there, cannot be opened or is not what it seems. One line: what, where, how
/// to mend it. Programs end with exit code 4.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace moontrace
