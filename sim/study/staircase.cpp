#include "sim/study/staircase.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "lessons/progress/item_choice.h"

namespace moontrace {
namespace {

bool Steps(const StaircaseRule& rule) {
  return !rule.steps.empty() &&
         std::all_of(rule.steps.begin(), rule.steps.end(), [&rule](double step) {
           return std::isfinite(step) && step > (rule.geometric ? 1 : 0);
         });
}

bool LeadsSomewhere(const StaircaseRule& rule) {
  const bool levels =
      rule.least <= rule.start && rule.start <= rule.most && (!rule.geometric || rule.start > 0);
  return rule.down >= 1 && rule.down <= 3 && levels && Steps(rule) && rule.discard >= 0 &&
         rule.stop_reversals > 0 && rule.stop_trials > 0;
}

}  // namespace

Staircase::Staircase(StaircaseRule rule) : rule_(std::move(rule)), level_(rule_.start) {
  if (!LeadsSomewhere(rule_)) throw std::invalid_argument("staircase: the rule leads nowhere");
}

bool Staircase::done() const {
  return trials_ >= rule_.stop_trials ||
         reversals_.size() >= static_cast<std::size_t>(rule_.stop_reversals);
}

void Staircase::Add(bool right) {
  if (done()) return;
  ++trials_;
  if (!right) {
    right_run_ = 0;
    Move(1);
  } else if (++right_run_ == rule_.down) {
    right_run_ = 0;
    Move(-1);
  }
}

void Staircase::Move(int direction) {
  if (direction_ != 0 && direction != direction_) reversals_.push_back(level_);
  direction_ = direction;
  const double step = rule_.steps[std::min(reversals_.size(), rule_.steps.size() - 1)];
  const double next =
      rule_.geometric ? (direction > 0 ? level_ * step : level_ / step) : level_ + direction * step;
  level_ = std::clamp(next, rule_.least, rule_.most);
}

std::optional<double> Staircase::Threshold() const {
  const auto discard = static_cast<std::size_t>(rule_.discard);
  if (reversals_.size() < discard + 2) return std::nullopt;
  const std::size_t first = discard + (reversals_.size() - discard) % 2;
  double sum = 0;
  for (std::size_t i = first; i < reversals_.size(); ++i) {
    sum += rule_.geometric ? std::log(reversals_[i]) : reversals_[i];
  }
  const double mean = sum / static_cast<double>(reversals_.size() - first);
  return rule_.geometric ? std::exp(mean) : mean;
}

std::optional<std::size_t> NextStaircase(const std::vector<Staircase>& staircases,
                                         std::uint64_t& random) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < staircases.size(); ++i) {
    if (!staircases[i].done()) open.push_back(i);
  }
  if (open.empty()) return std::nullopt;
  return open[NextRandom(random) % open.size()];
}

}  // namespace moontrace
