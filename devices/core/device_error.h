#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace moontrace {

/// A device that is not there, cannot be opened or is not what it seems. One line: what, where, how
/// to mend it. Programs end with exit code 4.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// It is there, and this user may not open it.
class PermissionError : public DeviceError {
 public:
  /// `rule` is the udev line that mends it; empty where none is known.
  PermissionError(const std::string& line, std::string rule)
      : DeviceError(line), rule_(std::move(rule)) {}
  const std::string& rule() const { return rule_; }

 private:
  std::string rule_;
};

}  // namespace moontrace
