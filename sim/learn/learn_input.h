#pragma once

#include <optional>
#include <string>

namespace moontrace {

/// Where a lesson's lines come from: typed with Enter, or made of single keys.
class LearnInput {
 public:
  virtual ~LearnInput() = default;
  /// The next line, waiting at most `milliseconds`. `asked`: an answer is awaited.
  virtual std::optional<std::string> Next(int milliseconds, bool asked) = 0;
  /// No line will ever come again.
  virtual bool ended() const = 0;
};

}  // namespace moontrace
