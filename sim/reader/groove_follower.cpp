#include "sim/reader/groove_follower.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "textures/base/units.h"

namespace moontrace {
namespace {

// Shares of a groove's width, unless said; ours, chosen on seeds 1 to 20.
constexpr double kSpeedShare = 0.5;  ///< of the speed at which a wall just holds
constexpr double kStopShare = 0.25;  ///< of the hold stops the aim
constexpr double kPullShare = 0.30;  ///< of the hold, in a swing
constexpr double kCalm = 0.020;      ///< of forces [s]
constexpr double kYield = 0.25;      ///< in which the aim yields to a wall [s]
constexpr double kSpacing = 0.12;    ///< of the path's points
constexpr double kBase = 1.6;        ///< of the path, from which its direction is taken
constexpr double kForesight = 0.8;   ///< of the way that is not yet felt
constexpr double kMostBend = 1.2;    ///< that is foreseen [rad]
constexpr double kStill = 0.08;      ///< less motion within kStopTime is a stop
constexpr double kStopTime = 0.090;  ///< [s]
constexpr double kBackTime = 0.25;   ///< [s]
constexpr double kWandered = 1.3;    ///< of an unsure place's error, round a ring
constexpr double kWanders = 0.4;     ///< the same, in so long [s]
constexpr double kStrays = 0.6;      ///< the same, in a swing
constexpr double kClosed = 0.6;      ///< from where it was before: a ring
constexpr double kMoved = 0.6;       ///< is motion out of a stop
constexpr double kSwingAngle = 100 * kDegree;
constexpr double kSwingRate = 12;              ///< [rad/s]
constexpr double kSharpAngle = 140 * kDegree;  ///< for a corner that is expected to be sharp
constexpr double kSharpTime = 0.10;            ///< longer on a side then [s]
constexpr double kLostDepth = 0.25;            ///< of the groove's depth
constexpr double kLostTime = 0.030;            ///< [s]
constexpr int kMostSwings = 12;

glm::dvec2 Turned(glm::dvec2 v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

double Cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

}  // namespace

GrooveFollower::GrooveFollower(const ReaderKnowledge& knowledge)
    : width_(knowledge.width),
      hold_(knowledge.Hold()),
      stiffness_(knowledge.hand_stiffness),
      late_(knowledge.delay + knowledge.lag),
      wait_(knowledge.delay + knowledge.lag + 0.060),
      speed_(kSpeedShare * hold_ / (stiffness_ * (knowledge.delay + 0.05))),
      gentle_(kTurn * std::sqrt(knowledge.hand_mass / knowledge.hand_stiffness)),
      longest_(6 * knowledge.greatest_size),
      closed_(std::hypot(kClosed * width_, kWandered * knowledge.unsure)),
      still_(kStill * width_ + kStopTime * knowledge.unsure / kWanders),
      moved_(kMoved * width_ + kStrays * knowledge.unsure) {}

void GrooveFollower::Begin(const Felt& felt, glm::dvec2 aim, glm::dvec2 direction,
                           double feels_from) {
  aim_ = aim;
  feels_from_ = feels_from;
  wall_ = felt.wall;
  path_.clear();
  blocked_.clear();
  length_ = 0;
  swings_ = 0;
  leg_ = 0;
  sure_ = 1;
  side_ = 1;
  lost_for_ = 0;
  has_moved_ = false;
  last_time_ = felt.time;
  direction_ = direction;
  path_.push_back(felt.place);
  StartSwing(felt);
}

glm::dvec2 GrooveFollower::Departure() const {
  std::size_t last = path_.size();
  while (last > 1 && glm::distance(path_[last - 1], path_.front()) > width_) --last;
  const glm::dvec2 way = path_[std::min(last, path_.size() - 1)] - path_.front();
  const double length = glm::length(way);
  return length > 0 ? way / length : direction_;
}

void GrooveFollower::Turn(glm::dvec2 direction, double time) {
  const double bend = Cross(direction_, direction);
  if (std::abs(bend) > 0.3) side_ = bend > 0 ? 1 : -1;
  direction_ = direction;
  has_moved_ = true;
  since_ = time;
  leg_ = path_.size() - 1;
  back_since_ = time;
  state_ = State::kMoving;
}

void GrooveFollower::StartSwing(const Felt& felt) {
  Stop(felt);
  left_ = right_ = true;
  glances_ = sharp_ = false;
  state_ = State::kSwinging;
}

void GrooveFollower::Stop(const Felt& felt) {
  state_ = State::kStopped;
  stop_ = felt.place;
  anchor_ = aim_ + wall_ / stiffness_;  // where the hand would not push at all
  since_ = felt.time;
  from_ = aim_;
  angle_ = 0;
  ++swings_;
}

void GrooveFollower::Try(bool left, bool right, bool sharp) {
  glances_ = !left && !right;
  sharp_ = sharp;
  left_ = left || glances_;
  right_ = right || glances_;
  if (left != right) side_ = left ? 1 : -1;
  state_ = State::kSwinging;
}

/// The angle of the swing after a time; a glance does not wait on either side for what it feels.
double GrooveFollower::AngleAt(double t) const {
  const double most = SwingAngle();
  const double first = glances_ ? most / kSwingRate : SideTime();
  if (t < 0) return 0;
  if (t < first) return side_ * std::min(most, kSwingRate * t);
  return side_ * std::max(-most, most - kSwingRate * (t - first));
}

double GrooveFollower::SwingAngle() const { return sharp_ ? kSharpAngle : kSwingAngle; }

/// To one side, until what it feels there must have come.
double GrooveFollower::SideTime() const {
  return SwingAngle() / kSwingRate + wait_ + (sharp_ ? kSharpTime : 0);
}

double GrooveFollower::SwingTime() const {
  if (glances_) return 3 * SwingAngle() / kSwingRate + wait_;
  const double over = SwingAngle() / kSwingRate;
  return left_ && right_ ? over + 2 * SideTime() : SideTime();
}

/// The tip went there in the groove, however far it is.
void GrooveFollower::AddPoint(glm::dvec2 p) {
  const glm::dvec2 from = path_.back();
  const double way = glm::distance(from, p);
  const int parts = std::max(1, static_cast<int>(std::lround(way / (kSpacing * width_))));
  for (int i = 1; i <= parts; ++i) {
    path_.push_back(from + static_cast<double>(i) / parts * (p - from));
  }
  length_ += way;
}

/// Whether `p` lies on the path's earlier part: the tip runs back along the groove it came by.
bool GrooveFollower::IsGoingBack(glm::dvec2 p) const {
  double behind = 0;
  for (std::size_t i = path_.size() - 1; i > 0; --i) {
    behind += glm::distance(path_[i], path_[i - 1]);
    if (behind > 3 * width_) return false;
    if (behind > 0.3 * width_ && glm::distance(path_[i - 1], p) < 0.3 * width_) return true;
  }
  return false;
}

/// Whether the newest point is back on the path, in the same direction, with an area enclosed: a
/// tip that bounces at an end encloses none.
bool GrooveFollower::HasClosed() const {
  const glm::dvec2 now = path_.back();
  double length = 0, area = 0;
  for (std::size_t i = path_.size() - 1; i > 0; --i) {
    const glm::dvec2 a = path_[i - 1] - now, b = path_[i] - now;
    area += 0.5 * Cross(a, b);
    length += glm::distance(a, b);
    if (length < 5 * width_ || glm::length(a) > closed_) continue;
    if (glm::dot(b - a, direction_) < 0.5 * glm::distance(a, b)) continue;
    if (std::abs(area) > 3 * width_ * width_) return true;
  }
  return false;
}

/// The direction that the groove will have where the tip is by now: a parabola through the newest
/// part of the path, led on by the way that is not yet felt.
glm::dvec2 GrooveFollower::Foreseen() const {
  glm::dvec2 sy{0, 0}, ty{0, 0};
  double s2 = 0, s3 = 0, s4 = 0, s = 0;
  int count = 0;
  const glm::dvec2 last = path_.back();
  // p(s) = last + a s + b s^2, s < 0 behind
  for (std::size_t i = path_.size() - 1; i > leg_; --i) {
    s -= glm::distance(path_[i], path_[i - 1]);
    if (s < -kBase * width_) break;
    const glm::dvec2 p = path_[i - 1] - last;
    s2 += s * s;
    s3 += s * s * s;
    s4 += s * s * s * s;
    ++count;
    sy += s * p;
    ty += s * s * p;
  }
  if (count < 1) return direction_;
  const double det = s2 * s4 - s3 * s3;
  const glm::dvec2 straight = sy / s2;
  glm::dvec2 heading = straight;
  if (count >= 4 && det > 1e-12 * s2 * s4) {
    const glm::dvec2 a = (s4 * sy - s3 * ty) / det, b = (s2 * ty - s3 * sy) / det;
    heading = a + 2.0 * kForesight * ahead_ * late_ * b;
    const double bend = std::atan2(Cross(straight, heading), glm::dot(straight, heading));
    heading = Turned(straight, std::clamp(bend, -kMostBend, kMostBend));
  }
  const double length = glm::length(heading);
  return length > 0 ? heading / length : direction_;
}

/// A hand on its spring swings to and fro a little; one that goes on going back has turned round.
void GrooveFollower::GoBack(const Felt& felt) {
  if (felt.time - back_since_ > kBackTime) Stop(felt);
}

void GrooveFollower::Move(const Felt& felt) {
  if (glm::distance(felt.place, path_.back()) > kSpacing * width_) {
    if (IsGoingBack(felt.place)) return GoBack(felt);
    back_since_ = felt.time;
    AddPoint(felt.place);
    if (glm::distance(felt.place, path_[leg_]) > 0.3 * width_) {
      const glm::dvec2 direction = Foreseen();
      const double bend = Cross(direction_, direction);
      if (std::abs(bend) > 0.1) side_ = bend > 0 ? 1 : -1;
      direction_ = direction;
    }
    if (HasClosed()) state_ = State::kRing;
    if (length_ > longest_) state_ = State::kEnded;
  }
  if (felt.time - mark_time_ < kStopTime) return;
  const bool still = glm::distance(felt.place, mark_) < still_;
  mark_ = felt.place;
  mark_time_ = felt.time;
  if (still && felt.time - since_ > wait_ && state_ == State::kMoving) Stop(felt);
}

void GrooveFollower::NoteBlocked() {
  constexpr double kStep = 20 * kDegree;
  for (int i = right_ ? -5 : -1; i <= (left_ ? 5 : 1); ++i) {
    blocked_.push_back({stop_ + 0.9 * width_ * Turned(direction_, i * kStep), 0.5});
  }
}

void GrooveFollower::Swing(const Felt& felt) {
  const glm::dvec2 way = felt.place - stop_;
  if (glm::length(way) > moved_ && !IsGoingBack(felt.place)) {
    AddPoint(felt.place);
    mark_ = felt.place;
    mark_time_ = felt.time;
    Turn(glm::normalize(way), felt.time);
    return;
  }
  // straight on at first where nothing has moved yet, then to one side, then to the other
  const double t = felt.time - since_ - (has_moved_ ? 0 : wait_);
  angle_ = AngleAt(t);
  if (t > SwingTime()) {
    NoteBlocked();
    state_ = State::kEnded;
  }
  if (swings_ > kMostSwings) state_ = State::kEnded;
}

/// The aim goes ahead, the slower the more a wall opposes it, and yields sideways.
void GrooveFollower::Steer(double dt) {
  const double opposed = std::max(0.0, -glm::dot(wall_, direction_));
  ahead_ = speed_ * std::max(0.0, 1 - opposed / (kStopShare * hold_));
  const glm::dvec2 aside = wall_ - glm::dot(wall_, direction_) * direction_;
  aim_ += dt * (ahead_ * direction_ + aside / (stiffness_ * kYield));
}

glm::dvec2 GrooveFollower::Step(const Felt& felt) {
  const double dt = felt.time - last_time_;
  last_time_ = felt.time;
  if (felt.time < feels_from_) return aim_ = SwungAim(felt.time);
  wall_ += std::min(1.0, dt / kCalm) * (felt.wall - wall_);
  lost_for_ = felt.depth < kLostDepth ? lost_for_ + dt : 0;
  if (felt.held) sure_ = path_.size();
  if (lost_for_ > kLostTime) {
    state_ = State::kLost;
    path_.resize(std::max<std::size_t>(1, sure_));  // where it was held last
  }
  if (state_ == State::kMoving) {
    Move(felt);
  } else if (state_ == State::kSwinging) {
    Swing(felt);
  }
  if (state_ == State::kMoving) Steer(dt);
  if (state_ == State::kSwinging) aim_ = SwungAim(felt.time);
  return aim_;
}

glm::dvec2 GrooveFollower::SwungAim(double time) const {
  const glm::dvec2 aim = anchor_ + kPullShare * hold_ / stiffness_ * Turned(direction_, angle_);
  return from_ + std::min(1.0, (time - since_) / gentle_) * (aim - from_);
}

}  // namespace moontrace
