#pragma once

#include <algorithm>

namespace moontrace {

/// Watches the energy that rendering puts out (a passivity observer after Hannaford and Ryu 2002,
/// with the stored energy known instead of assumed zero). Its balance is
///
///   G = work done on the hand and on the page's body so far + energy stored now.
///
/// What is passive never lets G rise: whatever it gives it takes from its store or from work done
/// on it before. The work over a tick is the force that was held times the travel while it was
/// held, so the energy that sampling and holding create is seen, as the hand gets it. Trivially
/// copyable.
class PassivityObserver {
 public:
  /// Begins, or begins again after a jump (another page, a reset): the balance goes on from here.
  void Rebase(double stored) noexcept { stored_ = stored; }
  /// One tick: `work` given out since the last one [J], `stored` now [J].
  void Add(double work, double stored) noexcept {
    balance_ += work + (stored - stored_);
    stored_ = stored;
    least_ = std::min(least_, balance_);
    energy_out_ = std::max(energy_out_, balance_ - least_);
  }
  /// Greatest rise of G above its least value before [J]: zero for ever if passive, bounded if
  /// energy is only borrowed, growing if it is created.
  double energy_out() const noexcept { return energy_out_; }

 private:
  double stored_ = 0;      ///< at the last tick [J]
  double balance_ = 0;     ///< G less its first value [J]
  double least_ = 0;       ///< of the balance [J]
  double energy_out_ = 0;  ///< [J]
};

}  // namespace moontrace
