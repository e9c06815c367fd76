#include "sim/reader/reader.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

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
constexpr double kSure = 0.99, kVerySure = 0.9995;  ///< the latter of what tells the size
constexpr double kPoorFit = 0.5;                    ///< cost a groove point by itself
constexpr int kMostSkips = 5;
constexpr double kDoubtful = 0.9;  ///< less sure signs are felt anew
constexpr int kMostCrossings = 10, kMostTries = 2, kMostCircles = 3;
constexpr double kCrossedWeight = 2;
// Of a spot, in widths of a groove: a dot is two wide, and the tip keeps to its middle.
constexpr double kSpot = 1.5, kRound = 1.75;
constexpr double kSurelySpot = 0.6;  ///< already after one leg

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

/// Where the groove stops, the hand tries those sides to which some likely sign goes on.
void Reader::TrySides() {
  constexpr double kLikely = 7;             // nats below the best
  constexpr double kUnlikely = 3;           // the same of what is no sign
  constexpr double kFrom = 0.9, kTo = 2.2;  // widths from the stop
  constexpr double kLeast = 25 * kDegree, kMost = 150 * kDegree;
  // a sharper corner is told from the groove it came by only farther away
  constexpr double kFar = 1.6, kSharpest = 168 * kDegree;
  TakeGrooves();
  if (signs_ < 2) return follower_.Try(true, true);
  const std::vector<SignGuess> belief = Believe(*knowledge_.shapes, evidence_, PriorNow());
  bool left = belief.empty(), right = belief.empty(), sharp = false;
  const glm::dvec2 ahead = follower_.direction();
  for (const SignGuess& guess : belief) {
    if (guess.log_likelihood < belief.front().log_likelihood - kLikely) break;
    if (guess.sign == SignGuess::kUnknown) {
      if (guess.log_likelihood > belief.front().log_likelihood - kUnlikely) left = right = true;
      continue;
    }
    for (const SignPoint& point : knowledge_.shapes->Points(guess.sign)) {
      const glm::dvec2 way = FromEm(guess.place, point.p) - follower_.stop();
      const double length = glm::length(way) / knowledge_.width;
      if (length < kFrom || length > kTo) continue;
      const double angle = std::atan2(ahead.x * way.y - ahead.y * way.x, glm::dot(ahead, way));
      const glm::dvec2 on =
          FromEm(guess.place, point.p + point.tangent) - FromEm(guess.place, point.p);
      const bool leads_back = std::abs(ahead.x * on.y - ahead.y * on.x) <
                              std::sin(std::numbers::pi - kSharpest) * glm::length(on);
      const double most = length < kFar || leads_back ? kMost : kSharpest;
      left = left || (angle > kLeast && angle < most);
      right = right || (angle < -kLeast && angle > -most);
      sharp = sharp || (std::abs(angle) > kMost && std::abs(angle) < most);
    }
  }
  follower_.Try(left, right, sharp);
}

/// From where a groove was met it is followed one way and then the other. A leg that ended where
/// the one before did has gone the same way.
void Reader::EndLeg() {
  TakePath();
  if (follower_.state() == GrooveFollower::State::kLost) {
    evidence_.grooves.insert(evidence_.grooves.end(), first_leg_.begin(), first_leg_.end());
  }
  first_leg_.clear();
  const glm::dvec2 end = follower_.path().back();
  const bool same = legs_ > 0 && glm::distance(end, leg_end_) < 1.5 * knowledge_.width;
  leg_end_ = end;
  ++legs_;
  const bool ring = follower_.state() == GrooveFollower::State::kRing;
  if (GoRound()) return;
  if (!ring && (legs_ == 1 || (legs_ == 2 && same))) {
    if (legs_ == 1 && KnowsTheRest()) return Think();
    if (legs_ == 1 && TurnBack()) return;
    first_direction_ = follower_.Departure();
    FlyTo(entry_, Phase::kFollow);
  } else {
    Think();
  }
}

/// A hand that is not sure of its place does not find back to where it met a groove, and has
/// another error there. It turns where it is, and feels the whole groove in one go, which is all
/// that counts then.
bool Reader::TurnBack() {
  constexpr double kUnsure = 0.2;  // of a groove's width
  constexpr double kBack = 1.5;    // widths; the direction is that of so much of the path
  if (knowledge_.unsure < kUnsure * knowledge_.width) return false;
  if (follower_.state() != GrooveFollower::State::kEnded) return false;
  const std::vector<glm::dvec2>& path = follower_.path();
  std::size_t i = path.size() - 1;
  while (i > 0 && glm::distance(path[i], path.back()) < kBack * knowledge_.width) --i;
  const glm::dvec2 back = path[i] - path.back();
  if (!(glm::length(back) > 0)) return false;
  first_leg_ = std::move(evidence_.grooves);
  evidence_.grooves.clear();
  follower_.Begin(sense_.felt(), glm::dvec2(action_.aim), glm::normalize(back), now_);
  return true;
}

/// Whether one leg has felt nearly all of a sign of which there is no doubt.
bool Reader::KnowsTheRest() {
  constexpr double kNearly = 0.3;         // of its lines all lies so near what was felt [em]
  constexpr std::size_t kFirstSigns = 4;  // tell of size and line, and are felt wholly
  if (signs_ < kFirstSigns) return false;
  belief_ = Believe(*knowledge_.shapes, evidence_, PriorNow());
  if (belief_.empty() || belief_.front().sign == SignGuess::kUnknown) return false;
  return Sureness() > kVerySure && FarthestUnfelt(belief_.front()).room < kNearly;
}

/// Round all grooves of the sign so far.
Box Reader::FeltBox() const {
  Box box;
  for (const FeltPoint& groove : evidence_.grooves) Include(box, groove.p);
  return box;
}

/// Whether all that was felt of the sign lies within so many widths.
bool Reader::FeltASpot(double widths) const {
  const Box box = FeltBox();
  return std::max(box.max.x - box.min.x, box.max.y - box.min.y) < widths * knowledge_.width;
}

/// Where a leg led nowhere the tip is in a dot, or in a groove that it could not enter: a circle
/// round the place tells, and what it falls into is followed.
bool Reader::GoRound() {
  constexpr int kCorners = 20;
  if (!FeltASpot(legs_ > 1 ? kSpot : kSurelySpot)) return false;
  if (circles_ >= kMostCircles) return false;
  ++circles_;
  const glm::dvec2 middle = 0.5 * (FeltBox().min + FeltBox().max);
  std::vector<glm::dvec2> way;
  way.reserve(kCorners + 1);
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    way.push_back(middle +
                  kRound * knowledge_.width * glm::dvec2(-std::cos(angle), std::sin(angle)));
  }
  SweepAlong(std::move(way), errand_);
  crossing_ = circling_ = true;
  return true;
}

/// What was felt twice says no more than once.
void Reader::TakeGrooves() {
  constexpr double kApart = 0.4, kOnItsOwn = 0.8;  // shares of the groove's width
  for (const glm::dvec2 p : follower_.path()) {
    const auto near = [&](const FeltPoint& felt) {
      return glm::distance(felt.p, p) < kApart * knowledge_.width;
    };
    if (std::none_of(evidence_.grooves.begin(), evidence_.grooves.end(), near)) {
      evidence_.grooves.push_back({p, kApart / kOnItsOwn});
    }
  }
}

void Reader::TakePath() {
  TakeGrooves();
  for (const FeltPoint& point : follower_.blocked()) evidence_.flats.push_back(point);
}

/// How sure the best answer is, other forms of the same sign counted with it.
double Reader::Sureness() const {
  const SignGuess& best = belief_.front();
  if (best.sign == SignGuess::kUnknown) return best.probability;
  double sum = 0;
  for (const SignGuess& guess : belief_) {
    if (MeanTheSame(guess, best)) sum += guess.probability;
  }
  return sum;
}

bool Reader::MeanTheSame(const SignGuess& a, const SignGuess& b) const {
  if (a.sign == SignGuess::kUnknown || b.sign == SignGuess::kUnknown) return a.sign == b.sign;
  // before it knows the size, the same sign at another size is another answer
  if (signs_ == 0 && std::abs(std::log(a.place.size / b.place.size)) > 0.13) return false;
  return knowledge_.shapes->MeaningOf(a.sign) == knowledge_.shapes->MeaningOf(b.sign);
}

void Reader::Think() {
  belief_ = Believe(*knowledge_.shapes, evidence_, PriorNow());
  if (belief_.empty()) return Missed();
  const SignGuess& best = belief_.front();
  if (best.sign == SignGuess::kUnknown && TakeGuide()) return;
  if ((signs_ == 0 || FeltASpot(kSpot)) && SkipFirst()) return;
  if (best.sign != SignGuess::kUnknown && Sureness() < kSure && crossings_ < kMostCrossings) {
    for (std::size_t i = 1; i < belief_.size() && belief_[i].probability > 0.002; ++i) {
      if (belief_[i].sign == SignGuess::kUnknown || MeanTheSame(belief_[i], best)) continue;
      if (CrossBetween(best, belief_[i]) || CrossBetween(belief_[i], best)) {
        ++crossings_;
        return;
      }
    }
  }
  if (best.sign != SignGuess::kUnknown && crossings_ < kMostCrossings && CrossUnfelt(best)) {
    ++crossings_;
    return;
  }
  if (best.sign == SignGuess::kUnknown && IsLastAgain()) {
    const std::vector<FeltPoint> felt = evidence_.grooves;
    return SearchBeyond(felt);
  }
  if (SkipFirst()) return;
  const bool doubtful = best.sign == SignGuess::kUnknown || Sureness() < kDoubtful;
  if (doubtful && tries_ < kMostTries) {
    ++tries_;
    const Box box = FeltBox();
    evidence_.grooves.clear();
    evidence_.flats.clear();
    crossings_ = circles_ = 0;
    SweepAcross(box);
    return;
  }
  Accept();
}

/// A sign that tells no size clearly tells something of it all the same, and several together tell
/// it.
void Reader::WeighSizes() {
  PlacePrior prior = PriorNow();
  const std::vector<double> logs = SizeLogs(*knowledge_.shapes, evidence_, prior);
  size_logs_.resize(sizes_.size(), 0);
  for (std::size_t i = 0; i < logs.size(); ++i) size_logs_[i] += logs[i];
  const double most = *std::max_element(size_logs_.begin(), size_logs_.end());
  for (double& log : size_logs_) log -= most;
}

/// Where a sign was felt, from where its line comes.
void Reader::SweepAcross(const Box& box) {
  const double y = box.min.y + (box.max.y - box.min.y) * (0.3 + 0.4 * random_.Uniform());
  const double left = box.min.x - (leftwards_ ? 0.2 : 0.4) * size_;
  const double right = box.max.x + (leftwards_ ? 0.4 : 0.2) * size_;
  SweepAlong({{leftwards_ ? right : left, y}, {leftwards_ ? left : right, y}}, errand_);
}

/// A page's first sign tells the size of all others, and a line's first one its height. One that
/// could be several (an upright is part of many, a dot stands at any height) is left for later: it
/// goes on to the right.
bool Reader::SkipFirst() {
  const bool first = errand_ == Errand::kFirstLine;
  if ((!first && errand_ != Errand::kNextLine) || skips_ >= kMostSkips) return false;
  double weight = 0;
  for (const FeltPoint& groove : evidence_.grooves) weight += groove.weight;
  const SignGuess& best = belief_.front();
  bool clear = best.sign != SignGuess::kUnknown && !knowledge_.shapes->IsDots(best.sign);
  clear = clear && (first ? Sureness() >= kVerySure && best.log_likelihood > -kPoorFit * weight
                          : Sureness() >= kDoubtful);
  if (clear) return false;
  Box box;  // what was only crossed may be of another line
  for (const FeltPoint& groove : evidence_.grooves) {
    if (!groove.crossed) Include(box, groove.p);
  }
  if (box.min.x > box.max.x) box = FeltBox();
  if (skips_++ == 0) first_skipped_ = box;
  if (first) WeighSizes();
  const double a = first ? knowledge_.least_size : size_;
  const double y = 0.5 * (box.min.y + box.max.y);
  std::vector<glm::dvec2> way;
  constexpr int kTurns = 60;
  way.reserve(kTurns);
  for (int i = 0; i < kTurns; ++i) {
    way.emplace_back(box.max.x + a * (0.2 + 0.15 * i), y + (i % 2 == 0 ? -0.35 : 0.35) * a);
  }
  evidence_.grooves.clear();
  evidence_.flats.clear();
  crossings_ = circles_ = tries_ = 0;
  SweepAlong(std::move(way), errand_);
  return true;
}

/// Share of what was felt that lies on a sign's lines or near them.
double Reader::ShareOf(const SignGuess& guess, const std::vector<FeltPoint>& grooves) const {
  constexpr double kNear = 0.12;  // [em]
  double all = 0, near = 0;
  for (const FeltPoint& groove : grooves) {
    all += groove.weight;
    const double d = knowledge_.shapes->Distance(guess.sign, ToEm(guess.place, groove.p));
    near += d < kNear ? groove.weight : 0;
  }
  return all > 0 ? near / all : 0;
}

/// Whether what was felt is the last sign's, met from its right side.
bool Reader::IsLastAgain() const {
  if (errand_ != Errand::kNextSign || line_.back().guess.sign == SignGuess::kUnknown) return false;
  return ShareOf(line_.back().guess, evidence_.grooves) > 0.7;
}

/// To either side of a line that is crossed [em].
double Reader::ReachAcross() const {
  constexpr double kReach = 0.2, kUnsures = 1.0;
  return kReach + kUnsures * knowledge_.unsure / size_;
}

Reader::Unfelt Reader::FarthestUnfelt(const SignGuess& guess) const {
  Unfelt farthest;
  for (const SignPoint& point : knowledge_.shapes->Points(guess.sign)) {
    const glm::dvec2 p = FromEm(guess.place, point.p);
    double room = INFINITY;
    for (const FeltPoint& felt : evidence_.grooves) room = std::min(room, glm::distance(felt.p, p));
    if (room / guess.place.size <= farthest.room) continue;
    farthest = {room / guess.place.size, point};
  }
  return farthest;
}

/// Goes across the part of a sign that is farthest from all that was felt, if that is far: what was
/// felt may be a part of it only.
bool Reader::CrossUnfelt(const SignGuess& guess) {
  constexpr double kFar = 0.25;  // [em]
  const double reach = ReachAcross();
  const Unfelt unfelt = FarthestUnfelt(guess);
  if (unfelt.room <= kFar) return false;
  const SignPoint& farthest = unfelt.point;
  const glm::dvec2 aside = reach * glm::dvec2(-farthest.tangent.y, farthest.tangent.x);
  SweepAlong({FromEm(guess.place, farthest.p + aside), FromEm(guess.place, farthest.p - aside)},
             errand_);
  crossing_ = true;
  return true;
}

/// Goes across a part of `other` that `best` does not have and that has not been felt.
bool Reader::CrossBetween(const SignGuess& best, const SignGuess& other) {
  const double reach = ReachAcross();
  constexpr double kOwn = 0.1;         // before a sign's end, more may be the next one's [em]
  constexpr double kBeyondCost = 0.6;  // as room
  double most = -INFINITY;
  glm::dvec2 from{0, 0}, to{0, 0};
  for (const SignPoint& point : knowledge_.shapes->Points(other.sign)) {
    const glm::dvec2 p = FromEm(other.place, point.p);
    double room = knowledge_.shapes->Distance(best.sign, ToEm(best.place, p));
    for (const FeltPoint& felt : evidence_.grooves) {
      room = std::min(room, glm::distance(felt.p, p) / other.place.size);
    }
    for (const FeltPoint& felt : evidence_.flats) {
      room = std::min(room, 2 * glm::distance(felt.p, p) / other.place.size);
    }
    // signs that follow lie ahead
    const double end = leftwards_ ? GapOf(best.sign) : knowledge_.shapes->Advance(best.sign);
    const double beyond = Ahead(best.place, p) - (end - kOwn);
    const double score = std::min(room, 0.3) - 0.1 * (leftwards_ ? -point.p.x : point.p.x) -
                         kBeyondCost * std::max(0.0, beyond);
    if (room < 0.17 || score <= most) continue;
    const glm::dvec2 normal(-point.tangent.y, point.tangent.x);
    const glm::dvec2 a = FromEm(other.place, point.p + reach * normal);
    const glm::dvec2 b = FromEm(other.place, point.p - reach * normal);
    const double free_a = knowledge_.shapes->Distance(best.sign, ToEm(best.place, a));
    const double free_b = knowledge_.shapes->Distance(best.sign, ToEm(best.place, b));
    if (std::max(free_a, free_b) < 0.12) continue;
    most = score;
    from = free_a > free_b ? a : b;
    to = free_a > free_b ? b : a;
    if (std::min(free_a, free_b) < 0.12) to = p + 0.3 * (to - p);
  }
  if (!std::isfinite(most)) return false;
  SweepAlong({from, to}, errand_);
  crossing_ = true;
  return true;
}

}  // namespace moontrace
