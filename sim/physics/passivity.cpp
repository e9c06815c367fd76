#include "sim/physics/passivity.h"

#include <algorithm>

namespace moontrace {

void PassivityObserver::Rebase(double stored) noexcept { stored_ = stored; }

void PassivityObserver::Add(double work, double stored) noexcept {
  balance_ += work + (stored - stored_);
  stored_ = stored;
  least_ = std::min(least_, balance_);
  energy_out_ = std::max(energy_out_, balance_ - least_);
}

}  // namespace moontrace
