#pragma once

#include <algorithm>

namespace moontrace {

/// Energy that rendering put out while the page was touched: the sum of the rises of
/// TickResult::energy_out (which never falls) in ticks of contact. In the air a hand feels the
/// coupling alone, so energy from there is not the page's.
class TouchEnergy {
 public:
  /// `energy_out` [J] since the loop began.
  void Add(double energy_out, bool in_contact) noexcept {
    if (in_contact) value_ += std::max(0.0, energy_out - last_);
    last_ = std::max(last_, energy_out);
  }
  double value() const noexcept { return value_; }  ///< [J]

 private:
  double last_ = 0;   ///< [J]
  double value_ = 0;  ///< [J]
};

}  // namespace moontrace
