#include "sim/reader/hatching_hand.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "textures/base/units.h"

namespace moontrace {
namespace {

// Ours, chosen on seeds 1 to 20 of pages that are read.
constexpr double kLift = 0.003;     // above the paper [m]
constexpr double kAirSpeed = 0.25;  // [m/s]
constexpr double kUp = 0.08;        // before it moves aside [s]
constexpr double kSteady = 0.08;    // for the hand to come to rest above the paper [s]
constexpr double kRests = 0.05;     // on the paper [s]
constexpr double kPatience = 1.0;   // with a landing that does not come to rest [s]
constexpr double kAtEnd = 0.05;     // longer than it feels late [s]
constexpr double kCalm = 0.006;     // [s]
constexpr double kFlat = 0.1;       // more is not flat paper, share of a groove's depth

}  // namespace

HatchingHand::HatchingHand(const ReaderKnowledge& knowledge, double speed, double learn,
                           double tick)
    : speed_(speed),
      flight_(kTurn * std::sqrt(knowledge.hand_mass / knowledge.hand_stiffness)),
      late_(knowledge.delay + knowledge.lag),
      press_(knowledge.press),
      sense_(knowledge, tick),
      drift_(knowledge, learn, tick) {}

void HatchingHand::Add(const ReaderInput& input) {
  now_ = input.time;
  sense_.Add(input, action_.press > 0);
  if (!begun_) put_ = felt().tip.z;
  begun_ = true;
  if (sweeps()) Calm(now_ - since_);
}

void HatchingHand::Calm(double dt) {
  const Felt& felt = sense_.felt();
  const double share = felt.touching && calm_.touching ? std::min(1.0, dt / kCalm) : 1;
  calm_.time = felt.time;
  calm_.touching = felt.touching;
  calm_.tip = felt.tip;
  calm_.place += share * (felt.place - calm_.place);
  calm_.wall += share * (felt.wall - calm_.wall);
  calm_.depth += share * (felt.depth - calm_.depth);
}

void HatchingHand::Go(std::vector<glm::dvec2> way) {
  way_ = std::move(way);
  state_ = State::kFlies;
  fly_from_ = glm::dvec2(felt().tip);
  aim_ = way_.front();
  next_ = 0;
  waited_ = 0;
  ended_ = false;
  since_ = now_;
  calm_.touching = false;  // what it felt there says nothing of where it lands
  sense_.Lift();
  drift_.Begin();
}

ReaderAction HatchingHand::Move(const std::function<void()>& more) {
  if (state_ == State::kFlies) return action_ = Fly();
  const double dt = now_ - since_;
  since_ = now_;
  Walk(dt * speed_, more);
  // what is felt comes late: wait at the end
  waited_ = next_ >= way_.size() ? waited_ + dt : 0;
  ended_ = waited_ > late_ + kAtEnd;
  if (ended_) return action_;
  const glm::dvec2 aim = aim_ - drift_.left() * glm::dvec2(-heading_.y, heading_.x);
  drift_.Add(glm::dvec2(calm_.tip), calm_.touching && calm_.depth < kFlat, aim, heading_);
  return action_ = {{aim.x, aim.y, sense_.level()}, press_};
}

void HatchingHand::Walk(double length, const std::function<void()>& more) {
  while (length > 0) {
    if (next_ >= way_.size()) more();
    if (next_ >= way_.size()) break;
    const glm::dvec2 left = way_[next_] - aim_;
    const double distance = glm::length(left);
    if (distance > 0) heading_ = left / distance;
    if (distance > length) {
      aim_ += length / distance * left;
      length = 0;
    } else {
      aim_ = way_[next_++];
      length -= distance;
    }
  }
}

ReaderAction HatchingHand::Fly() {
  const double t = now_ - since_;
  const glm::dvec2 to = way_.front();
  // an even movement over whole periods of its spring leaves a hand at rest
  const double distance = glm::distance(fly_from_, to);
  const double moves = flight_ * std::max(1.0, std::ceil(distance / (kAirSpeed * flight_)));
  const double there = kUp + moves + kSteady;
  const double height = level_known() ? sense_.surface() + kLift : put_;
  if (t < there) {
    const double share = std::clamp((t - kUp) / moves, 0.0, 1.0);
    const glm::dvec2 over = glm::mix(fly_from_, to, share);
    return {{over.x, over.y, height}, 0};
  }
  const bool rests = level_known() && sense_.resting_for() > kRests;
  if (t >= there + late_ && (rests || t > there + late_ + kPatience)) {
    state_ = State::kSweeps;
    since_ = now_;
  }
  return {{to.x, to.y, felt().tip.z}, press_};
}

ReaderAction HatchingHand::Lifted() const {
  return {{felt().tip.x, felt().tip.y, sense_.surface() + kLift}, 0};
}

}  // namespace moontrace
