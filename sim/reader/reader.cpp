// How a reader moves: over the paper, along a way until it falls into a groove, and back onto a
// face.
#include "sim/reader/reader.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "textures/base/units.h"

namespace moontrace {
namespace {

// Ours, chosen on seeds 1 to 20. In em unless said.
constexpr double kLift = 0.0015;     ///< above the paper [m]
constexpr double kSurelyUp = 0.004;  ///< the same where it cannot feel the paper's height [m]
constexpr double kAirSpeed = 0.35;   ///< [m/s]
constexpr double kPatience = 1.0;    ///< with a landing that does not come to rest [s]
constexpr double kGivesUp = 300;     ///< after so long without a sign or a line [s]
constexpr double kSteady = 0.03;     ///< for the hand to come to rest above a groove [s]
constexpr double kCareful = 0.10;    ///< the same above what was never felt [s]
constexpr double kFall = 0.08;       ///< onto the paper [s]
constexpr double kLands = 0.02;      ///< before a sweep begins [s]
constexpr double kBounce = 0.04;     ///< after which the paper is felt as it is [s]
constexpr double kUp = 0.06;         ///< to leave a groove before moving aside [s]
// Of an object's face.
constexpr double kInside = 0.001;      ///< of its edges a hand stays that is led by a groove [m]
constexpr double kBeside = 0.003;      ///< and one that searches or lands [m]
constexpr double kFallen = 0.003;      ///< below a groove's floor [m]
constexpr double kNoFace = 0.030;      ///< below where the hand was put [m]
constexpr double kAway = 0.010;        ///< from an edge that it fell over, to rise beside it [m]
constexpr double kClimb = 0.5;         ///< back above the face [s]
constexpr double kLeftOut = 0.3;       ///< of a way, more each time
constexpr int kMostFalls = 20;         ///< on one way
constexpr double kSearchShare = 0.85;  ///< of the speed at which a groove's wall just holds
constexpr double kCaughtDepth = 0.4;   ///< share of a groove's depth
constexpr double kCaughtTime = 0.006;  ///< [s]
constexpr double kFlatDepth = 0.12;
constexpr double kCrossedWeight = 2;

}  // namespace

std::vector<double> Reader::AllSizes(const ReaderKnowledge& knowledge) {
  // the first line may be a heading
  const double ratio = knowledge.heading_scale * knowledge.greatest_size / knowledge.least_size;
  const int count = std::max(0, static_cast<int>(std::lround(std::log(ratio) / 0.04)));
  std::vector<double> sizes;
  for (int i = 0; i <= count; ++i) {
    sizes.push_back(knowledge.least_size * (count > 0 ? std::pow(ratio, 1.0 * i / count) : 1));
  }
  return sizes;
}

Reader::Reader(const ReaderKnowledge& knowledge, double tick, std::uint64_t seed)
    : knowledge_(knowledge),
      random_(seed),
      sense_(knowledge, tick),
      drift_(knowledge, tick),
      follower_(knowledge) {
  sizes_ = AllSizes(knowledge);
  size_ = std::sqrt(knowledge.least_size * knowledge.greatest_size);
  evidence_.width = knowledge.width;
  evidence_.unsure = knowledge.unsure;
}

ReaderAction Reader::Step(const ReaderInput& input) {
  now_ = input.time;
  const Felt& felt = sense_.Add(input, action_.press > 0);
  if (felt.touching) carried_ = felt.place;
  const bool long_enough = knowledge_.face && now_ > LongestOn(*knowledge_.face);
  if ((now_ - news_ > kGivesUp || long_enough) && phase_ != Phase::kDone) {
    if (!line_.empty()) EndLine();
    if (top_) tokens_ = read_above_;  // what lies below is no page's beginning
    phase_ = Phase::kDone;
  }
  if (phase_ != Phase::kDone && Falls(felt)) ComeBack();
  action_ = Act(felt);
  if (knowledge_.face && action_.press > 0) {
    action_.aim = {knowledge_.face->Held(glm::dvec2(action_.aim), kInside), action_.aim.z};
  }
  return action_;
}

/// However its signs are taken, a face is read in this time [s].
double Reader::LongestOn(const ReaderFace& face) const {
  constexpr double kAtLeast = 60, kASign = 15;  // [s]
  const glm::dvec2 signs = 2.0 * face.half / knowledge_.least_size;
  return kAtLeast + kASign * std::max(1.0, signs.x) * std::max(1.0, signs.y);
}

/// Whether the tip is beside what it reads, or went through it.
bool Reader::Falls(const Felt& felt) const {
  if (!knowledge_.face || felt.touching || action_.press <= 0) return false;
  if (!sense_.level_known()) return felt.tip.z < put_ - kNoFace;
  return felt.tip.z < sense_.level() - knowledge_.depth - kFallen;
}

/// Away from the face and up, then back to where it was at work. What of a way leads off again is
/// left out bit by bit.
void Reader::ComeBack() {
  if (phase_ == Phase::kFollow || (phase_ == Phase::kFly && then_ == Phase::kFollow)) {
    if (legs_ == 0) {  // the other way along the groove
      legs_ = 1;
      first_direction_ = follower_.Departure();
      FlyTo(entry_, Phase::kFollow);
    } else {
      Think();
    }
  } else {
    for (double step = kLeftOut * size_ * falls_; step > 0 && next_ < way_.size();) {
      const double left = glm::distance(aim_, way_[next_]);
      aim_ = left > step ? aim_ + step / left * (way_[next_] - aim_) : way_[next_++];
      step -= left;
    }
    if (next_ < way_.size() && ++falls_ <= kMostFalls) {
      FlyTo(aim_, Phase::kSweep);
    } else {
      crossing_ ? Think() : Missed();
    }
  }
  if (phase_ != Phase::kFly) return;
  fly_from_ += kAway * knowledge_.face->Outward(carried_);
  rise_ = kClimb;
}

/// A way as far as it lies on the face: what leads beyond an edge runs along that, and it ends
/// where it would only go to and fro on the same edge.
std::vector<glm::dvec2> Reader::WithinFace(std::vector<glm::dvec2> way) const {
  if (!knowledge_.face) return way;
  const ReaderFace& face = *knowledge_.face;
  std::vector<glm::dvec2> within;
  within.reserve(way.size());
  int beyond = 0;  // points in a row that lie off the face across the lines
  for (const glm::dvec2 p : way) {
    const glm::dvec2 held = face.Held(p, kBeside);
    const glm::dvec2 off = face.ToOwn(p) - face.ToOwn(held);
    beyond = std::abs(off.y) > kBeside ? beyond + 1 : 0;
    if (beyond > 2) break;
    if (within.empty() || glm::distance(within.back(), held) > 1e-6) within.push_back(held);
  }
  return within;
}

ReaderActivity Reader::activity() const {
  switch (phase_) {
    case Phase::kStart:
    case Phase::kFly:
      return ReaderActivity::kFlying;
    case Phase::kSweep:
      return crossing_ ? ReaderActivity::kCrossing : ReaderActivity::kSearching;
    case Phase::kSettle:
      return ReaderActivity::kSettling;
    case Phase::kFollow:
      return follower_.state() == GrooveFollower::State::kMoving ? ReaderActivity::kFollowing
                                                                 : ReaderActivity::kTurning;
    case Phase::kDone:
      break;
  }
  return ReaderActivity::kDone;
}

ReaderAction Reader::Act(const Felt& felt) {
  switch (phase_) {
    case Phase::kStart:
      start_ = carried_ = glm::dvec2(felt.tip);
      put_ = felt.tip.z;
      SearchFirstLine();
      return Fly(felt);
    case Phase::kFly:
      return Fly(felt);
    case Phase::kSweep:
      return Sweep(felt);
    case Phase::kSettle:
      return Settle(felt);
    case Phase::kFollow:
      return Follow(felt);
    case Phase::kDone:
      break;
  }
  return {{felt.tip.x, felt.tip.y, LiftedHeight()}, 0};
}

void Reader::FlyTo(glm::dvec2 to, Phase then) {
  phase_ = Phase::kFly;
  then_ = then;
  fly_from_ = glm::dvec2(sense_.felt().tip);
  const double within = then == Phase::kFollow ? kInside : kBeside;
  fly_to_ = knowledge_.face ? knowledge_.face->Held(to, within) : to;
  since_ = now_;
  rise_ = kUp;
  sense_.Lift();
  drift_.Begin();
}

double Reader::LiftedHeight() const {
  return knowledge_.feels_height ? sense_.surface() + kLift : kSurelyUp;
}

/// Up, over and down. What comes next begins before the landing is felt; the first one is waited
/// for, since it tells where the paper is.
ReaderAction Reader::Fly(const Felt& felt) {
  const double t = now_ - since_;
  // an even movement over whole periods of its spring leaves a hand at rest
  const double period = kTurn * std::sqrt(knowledge_.hand_mass / knowledge_.hand_stiffness);
  const double distance = glm::distance(fly_from_, fly_to_);
  const double moves = period * std::max(1.0, std::ceil(distance / (kAirSpeed * period)));
  const double careful = then_ == Phase::kFollow ? kSteady : 0;
  const double there = rise_ + moves + (sense_.level_known() ? careful : kCareful);
  const double felt_there = there + knowledge_.delay + knowledge_.lag;
  const double unknown = knowledge_.face ? put_ : felt.tip.z;
  const double height = sense_.level_known() ? LiftedHeight() : unknown;
  if (t < rise_) return {{fly_from_.x, fly_from_.y, height}, 0};
  if (t < there) {
    const glm::dvec2 over = glm::mix(fly_from_, fly_to_, std::min(1.0, (t - rise_) / moves));
    return {{over.x, over.y, height}, 0};
  }
  const bool rests = sense_.level_known() && sense_.resting_for() > 0.03;
  const bool goes_on = sense_.level_known() && t >= there + kFall;
  if (goes_on || (t >= felt_there && (rests || t > felt_there + kPatience))) {
    since_ = now_;
    phase_ = then_;
    caught_for_ = 0;
    const bool sweeps = then_ == Phase::kSweep;
    starts_ = goes_on && sweeps ? now_ + kLands : now_;
    feels_from_ = goes_on ? now_ + knowledge_.delay + (sweeps ? kBounce : knowledge_.lag) : now_;
    if (then_ == Phase::kFollow) {
      Felt landed = felt;
      if (goes_on) {
        landed.place = fly_to_;
        landed.wall = {0, 0};
      }
      follower_.Begin(landed, fly_to_, -first_direction_, feels_from_);
      return {{fly_to_.x, fly_to_.y, sense_.level()}, knowledge_.press};
    }
  }
  return {{fly_to_.x, fly_to_.y, sense_.level()}, knowledge_.press};
}

/// Flies to the way's first point and sweeps along it.
void Reader::SweepAlong(std::vector<glm::dvec2> way, Errand errand) {
  crossing_ = in_gap_ = circling_ = false;
  falls_ = 0;
  way_ = WithinFace(std::move(way));
  errand_ = errand;
  next_ = 1;
  aim_ = way_.front();
  last_flat_ = {INFINITY, INFINITY};
  FlyTo(way_.front(), Phase::kSweep);
}

ReaderAction Reader::Sweep(const Felt& felt) {
  const bool feels = now_ >= feels_from_;
  if (feels && felt.depth < kFlatDepth && felt.touching &&
      !(glm::distance(last_flat_, felt.place) < 0.3 * knowledge_.width)) {
    last_flat_ = felt.place;
    evidence_.flats.push_back({felt.place, 1, true});
  }
  const double dt = now_ - since_;  // since the last tick here
  since_ = now_;
  caught_for_ = feels && felt.depth > kCaughtDepth ? caught_for_ + dt : 0;
  if (caught_for_ > kCaughtTime) {
    Caught(felt);
    return action_;
  }
  double step = (now_ < starts_ ? 0 : dt) * kSearchShare * knowledge_.Hold() /
                (knowledge_.hand_stiffness * (knowledge_.delay + 0.05));
  while (next_ < way_.size() && step > 0) {
    const glm::dvec2 left = way_[next_] - aim_;
    const double length = glm::length(left);
    if (length > 1e-9) sweep_direction_ = left / length;
    if (length > step) {
      aim_ += step * sweep_direction_;
      step = 0;
    } else {
      aim_ = way_[next_++];
      step -= length;
    }
  }
  // what is felt comes late: wait at the end
  if (next_ >= way_.size()) {
    waited_ += dt;
    if (waited_ > knowledge_.delay + knowledge_.lag + 0.05) {
      waited_ = 0;
      if (crossing_) {
        Think();
      } else {
        Missed();
      }
    }
  } else {
    waited_ = 0;
  }
  const glm::dvec2 aim = aim_ - drift_.drift();
  if (feels) drift_.Add(felt, aim);
  return {{aim.x, aim.y, sense_.level()}, knowledge_.press};
}

/// Before it falls into a groove a tip flies on over it: that was no flat paper.
void Reader::Caught(const Felt& felt) {
  constexpr double kFlight = 0.5;  // of a groove's width
  phase_ = Phase::kSettle;
  since_ = now_;
  entry_ = felt.place;
  std::erase_if(evidence_.flats, [this](const FeltPoint& flat) {
    return flat.crossed && glm::distance(flat.p, entry_) < kFlight * knowledge_.width;
  });
  if (in_gap_ && MetGapsEnd(felt.place)) return;
  if (!crossing_ && !in_gap_ && errand_ == Errand::kNextSign && LeftAGap(felt.place)) return;
}

ReaderAction Reader::Settle(const Felt& felt) {
  const ReaderAction rest{{entry_.x, entry_.y, sense_.level()}, knowledge_.press};
  if (now_ - since_ < knowledge_.delay + knowledge_.lag + 0.01) return rest;
  since_ = now_;
  if (crossing_ && !circling_) {
    evidence_.grooves.push_back({felt.depth < 0.3 ? entry_ : felt.place, kCrossedWeight, true});
    Think();
    return rest;
  }
  if (felt.depth < 0.3) {  // slipped out: go on
    phase_ = Phase::kSweep;
    aim_ = felt.place;
    caught_for_ = 0;
    return rest;
  }
  phase_ = Phase::kFollow;
  legs_ = 0;
  entry_ = felt.place;
  follower_.Begin(felt, {rest.aim.x, rest.aim.y}, sweep_direction_, now_);
  return rest;
}

ReaderAction Reader::Follow(const Felt& felt) {
  const glm::dvec2 aim = follower_.Step(felt);
  if (follower_.state() == GrooveFollower::State::kStopped) TrySides();
  if (follower_.done()) EndLeg();
  return {{aim.x, aim.y, sense_.level()}, knowledge_.press};
}

}  // namespace moontrace
