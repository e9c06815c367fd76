#pragma once

#include <stdexcept>
#include <string>

namespace moontrace {

/// Bad input: a file, a text, a number. The text is one line: what is wrong, where, how to mend it.
/// Thrown at load time only, never in the tick. Programs end with exit code 3.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Something this machine lacks: a library, a display, a permission, room on the disk. One line.
/// Programs end with exit code 4.
class LackError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace moontrace
