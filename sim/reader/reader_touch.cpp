// How the reader feels one sign: it follows its grooves, thinks what they may be, and crosses what
// tells that apart.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "sim/reader/reader.h"
#include "textures/base/units.h"

namespace moontrace {
namespace {

// Ours, chosen on seeds 1 to 20. In em unless said.
constexpr double kSure = 0.99, kVerySure = 0.9995;  ///< the latter of what tells the size
constexpr double kPoorFit = 0.5;                    ///< cost a groove point by itself
constexpr int kMostSkips = 5;
constexpr double kDoubtful = 0.9;  ///< less sure signs are felt anew
constexpr int kMostCrossings = 10, kMostTries = 2, kMostCircles = 3;
// Of a spot, in widths of a groove: a dot is two wide, and the tip keeps to its middle.
constexpr double kSpot = 1.5, kRound = 1.75;
constexpr double kSurelySpot = 0.6;  ///< already after one leg

}  // namespace

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
  ++skips_;
  if (!first_skipped_) first_skipped_ = box;
  if (first) WeighSizes();
  const double a = first ? knowledge_.least_size : size_;
  const double y = 0.5 * (box.min.y + box.max.y);
  std::vector<glm::dvec2> way;
  constexpr int kTurns = 60;
  way.reserve(kTurns);
  for (int i = 0; i < kTurns; ++i) {
    way.emplace_back(box.max.x + a * (0.2 + 0.15 * i), y + (i % 2 == 0 ? -0.35 : 0.35) * a);
  }
  ForgetSign();
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
    const glm::dvec2 normal(-point.tangent.y, point.tangent.x);
    const glm::dvec2 a = FromEm(other.place, point.p + reach * normal);
    const glm::dvec2 b = FromEm(other.place, point.p - reach * normal);
    // signs that follow lie ahead: a way that reaches one would meet it in place of this
    const double end = leftwards_ ? GapOf(best.sign) : knowledge_.shapes->Advance(best.sign);
    const double beyond = std::max(Ahead(best.place, a), Ahead(best.place, b)) - (end - kOwn);
    const double score = std::min(room, 0.3) - 0.1 * (leftwards_ ? -point.p.x : point.p.x) -
                         kBeyondCost * std::max(0.0, beyond);
    if (room < 0.17 || score <= most) continue;
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
