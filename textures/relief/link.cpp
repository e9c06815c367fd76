#include "textures/relief/link.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "textures/base/units.h"
#include "textures/relief/clearance.h"

namespace moontrace {
namespace {

constexpr double kNoTurn = 1e-7;          // [rad]; what rounding leaves of a turn that is none
constexpr double kTurns[] = {1, 2.5, 6};  // in least radii; the last one where all else fails
constexpr double kRoughly = 1e-3;         // [rad]
constexpr double kNoCorner = 0.8;         // cosine of the bend below which there is a corner
constexpr double kStandsAt = 1.1;         // of the distance wanted, within which a wall is an end's
constexpr double kHair = 1e-3;            // of the distance wanted, that circles keep in addition
constexpr double kBesideCurve = 0.1;      // the same where a stroke bulges between corners
constexpr double kTightness = 6;          // [radius^2], see CostOf
constexpr double kAhead = 0.6;            // of the sharpest turn's radius, see IsShutIn
constexpr int kDotRays = 8;
// These bound the time of a hopeless task.
constexpr std::size_t kMostTries = 1500, kMostNodes = 600;
// The straight way is seldom free: what is nearer to the goal goes first.
constexpr double kToGo = 1.3;
constexpr double kLeastCrossing = 0.643;                    // sine of 40 degrees
constexpr double kLeastGoingOn = 0.49;                      // cosine of 60 degrees, and a hair
constexpr std::size_t kUsualNodes = 64, kUsualSteps = 256;  // for which room is made
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

glm::dvec2 LeftOf(glm::dvec2 v) { return {-v.y, v.x}; }

/// A circle travelled one way, counter-clockwise if the radius is above zero.
struct Turn {
  glm::dvec2 center{0, 0};  ///< [m]
  double radius = 0;        ///< [m]
  glm::dvec2 PointWhere(glm::dvec2 way) const { return center - radius * LeftOf(way); }
};

Turn TurnFrom(const Ray& ray, double radius) {
  return {ray.point + radius * LeftOf(ray.direction), radius};
}

/// The straight way that leaves one circle and arrives at another.
struct Tangent {
  bool exists = false;
  glm::dvec2 along{0, 0};  // its direction, `square` long
  double square = 0;       // [m^2], of the distance between the centres
  double length = 0;       // [m]
  glm::dvec2 Way() const {
    const glm::dvec2 way = along / square;
    return way / glm::length(way);
  }
};

Tangent TangentOf(const Turn& from, const Turn& to) {
  // It lies as far to the right of each centre as its radius says.
  const glm::dvec2 v = to.center - from.center;
  const double k = to.radius - from.radius;
  const double square = glm::dot(v, v), left = square - k * k;
  if (!(square > 0 && left >= 0)) return {};
  const double length = std::sqrt(left);
  return {true, length * v - k * LeftOf(v), square, length};
}

/// A turn, wide enough that it is not taken. Told without the angle, before what costs more.
struct WideTurn {
  double widest = 0;  ///< [rad], beyond half a turn
  double cosine = 0;  ///< of what that lacks of a whole one, and a hair more

  /// Whether the turn from a unit direction to another of this length is wider for certain.
  bool IsBelow(glm::dvec2 from, glm::dvec2 to, double length, double radius) const {
    const double aside = from.x * to.y - from.y * to.x;
    return radius != 0 && (radius > 0 ? -aside : aside) > 2 * kRoughly * length &&
           glm::dot(from, to) > cosine * length;
  }
};
constexpr WideTurn kEndTurn{5.3, 0.56};   // farther it would have to cross itself
constexpr WideTurn kWayTurn{4.2, -0.48};  // on the way

/// The length of the turn of SweepBetween, to a thousandth of a radian (a polynomial of the arc
/// tangent on [0, 1]): enough to tell which way is tried first.
double RoughSweep(glm::dvec2 from, glm::dvec2 to, double radius) {
  if (radius == 0) return 0;
  const double x = glm::dot(from, to), y = from.x * to.y - from.y * to.x;
  const double ax = std::abs(x), ay = std::abs(y);
  const double t = std::min(ax, ay) / std::max({ax, ay, 1e-300}), u = t * t;
  double angle = t * (1 - u * (0.327622764 - u * (0.15931422 - u * 0.0464964749)));
  if (ay > ax) angle = kTurn / 4 - angle;
  if (x < 0) angle = kTurn / 2 - angle;
  const bool is_back = radius > 0 ? y < 0 : y > 0;
  return is_back && angle > kRoughly ? kTurn - angle : angle;
}

/// The turn from one direction to another in the sense of `radius`; none on a point.
double SweepBetween(glm::dvec2 from, glm::dvec2 to, double radius) {
  if (radius == 0) return 0;
  const double angle = std::atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
  double sweep = radius > 0 ? angle : -angle;
  if (sweep < 0) sweep += kTurn;
  if (sweep < kNoTurn || sweep > kTurn - kNoTurn) sweep = 0;
  return radius > 0 ? sweep : -sweep;
}

/// Writes a turn that begins at `from`.
void WriteTurn(const Turn& turn, glm::dvec2 from, double sweep, std::vector<Piece>& pieces) {
  if (sweep == 0) return;
  const glm::dvec2 v = from - turn.center;
  pieces.push_back(Arc{turn.center, std::abs(turn.radius), std::atan2(v.y, v.x), sweep});
}

/// Asked of every wall: without a branch for each side, which would be guessed wrong.
bool AreNear(const Box& a, const Box& b) {
  return ((a.min.x <= b.max.x) & (b.min.x <= a.max.x) & (a.min.y <= b.max.y) &
          (b.min.y <= a.max.y)) != 0;
}

/// A wall with what rules most of it out at once.
struct Obstacle {
  Curve curve;
  double need = 0;                      ///< from its centre line to the link's [m]
  Box box;                              ///< within which that matters
  bool at_from = false, at_to = false;  ///< stands at the link's own ends: see FindLink
  bool is_turned_round = false;         ///< its circles are nodes
};

/// A circle that a link may turn on.
struct Node {
  Turn turn;
  double weight = 0;     ///< of its turn in the cost [m/rad]
  glm::dvec2 way{1, 0};  ///< in which it is entered at the start, or left at the goal
  bool is_last_resort = false;
  bool narrows = false;  ///< a point that is left or entered near `way` only
  /// Of the first (last) turn: as far it is known to be free, and from where on not [rad].
  double free = 0, blocked = 1e300;
};

/// A way as far as the point where it arrives at a circle.
struct Step {
  double cost = 0;    ///< [m]
  double length = 0;  ///< [m], once it was found free
  std::size_t from = kNone, to = kNone;
  glm::dvec2 way{0, 0};  ///< of the straight part
};

/// A step that is to be tried: the one of least bound first.
struct Entry {
  double bound = 0;
  std::size_t step = 0;
  bool operator<(const Entry& other) const { return bound > other.bound; }
};

/// A part of a way: a line, or an arc by its sweep.
struct Part {
  Curve curve;
  double sweep = 0;  ///< [rad]
  double length = 0;
};

Part TurnPart(const Turn& turn, glm::dvec2 into, glm::dvec2 out, double sweep) {
  if (sweep == 0) return {};
  const double radius = std::abs(turn.radius);
  return {ArcCurve(turn.center, radius, turn.PointWhere(into), turn.PointWhere(out), sweep), sweep,
          radius * std::abs(sweep)};
}

/// What lies between two lengths of a part.
Part Between(const Part& part, double from, double to) {
  if (part.sweep == 0) {
    const glm::dvec2 way = (part.curve.to - part.curve.from) / part.length;
    return {LineCurve(part.curve.from + from * way, part.curve.from + to * way), 0, to - from};
  }
  const double rate = part.sweep / part.length;
  const auto at = [&](double s) {
    const glm::dvec2 v = part.curve.from - part.curve.center;
    const double c = std::cos(rate * s), d = std::sin(rate * s);
    return part.curve.center + glm::dvec2(c * v.x - d * v.y, d * v.x + c * v.y);
  };
  const double sweep = rate * (to - from);
  return {ArcCurve(part.curve.center, part.curve.radius, at(from), at(to), sweep), sweep,
          to - from};
}

class LinkSearch {
 public:
  explicit LinkSearch(const LinkTask& task) : task_(task) {
    const std::size_t walls =
        task.from.walls.size() + task.to.walls.size() + task.others.size() + task.links.size();
    obstacles_.reserve(walls);
    order_.reserve(walls);
    nodes_.reserve(kUsualNodes);
    steps_.reserve(kUsualSteps);
    queue_.reserve(kUsualSteps);
    const LinkEnd* both = task.one_letter ? &task.to : nullptr;
    for (const LinkWall& wall : task.from.walls) AddWall(wall, &task.from, both);
    for (const LinkWall& wall : task.to.walls) AddWall(wall, nullptr, &task.to);
    for (const LinkWall& wall : task.others) AddWall(wall, nullptr, nullptr);
    for (const Piece& piece : task.links) {
      // at a dot links must meet
      const LinkEnd* from = task.from.is_dot ? &task.from : nullptr;
      const LinkEnd* to = task.to.is_dot ? &task.to : nullptr;
      if (!task.may_cross) AddWall({piece, task.half}, from, to);
      if (task.may_cross) crossed_.push_back(CurveOf(piece));
    }
    AddEnd(task.from);
    first_goal_ = nodes_.size();
    AddEnd(task.to);
    first_way_ = nodes_.size();
    reached_.resize(nodes_.size());
  }

  std::vector<Piece> Run() {
    if (IsShutIn(task_.from, 1) || IsShutIn(task_.to, -1)) return {};
    for (std::size_t i = 0; i < first_goal_; ++i) Expand(i, first_goal_, first_way_);
    std::vector<Piece> path;
    for (std::size_t tries = 0; tries < kMostTries; ++tries) {
      if (queue_.empty()) LookFarther();
      if (queue_.empty()) break;
      std::pop_heap(queue_.begin(), queue_.end());
      const Step step = steps_[queue_.back().step];
      queue_.pop_back();
      blocker_ = kNone;
      if (Take(step, path)) return path;
      // what is shortest of all is mostly free; only else there are ways round what is in its way
      if (blocker_ != kNone) AddWaysRound(blocker_);
    }
    return {};
  }

 private:
  /// Whether no way leads away from an open stroke's end (back from it, `sense` -1), since a wall
  /// closes what lies ahead: a point of a way whose turns are no sharper than r is after a length l
  /// at most l^2 / 2r away from the point that lies l straight ahead. What this rules out a search
  /// would try long and in vain.
  bool IsShutIn(const LinkEnd& end, double sense) const {
    if (end.is_dot || end.is_ring) return false;
    const Ray& ray = end.rays.front();
    const double sharpest = std::min(task_.radius, task_.half + task_.gap);
    const double ahead = kAhead * sharpest, aside = ahead * ahead / (2 * sharpest);
    const std::vector<Ray>& others = (sense > 0 ? task_.to : task_.from).rays;
    for (const Ray& other : others) {
      if (glm::distance(other.point, ray.point) < ahead) return false;  // it may end before
    }
    const glm::dvec2 p = ray.point + sense * ahead * ray.direction;
    return std::any_of(obstacles_.begin(), obstacles_.end(), [&](const Obstacle& wall) {
      return !wall.at_from && !wall.at_to && DistanceTo(wall.curve, p) < wall.need - aside;
    });
  }

  void AddWall(const LinkWall& wall, const LinkEnd* from, const LinkEnd* to) {
    Obstacle obstacle{CurveOf(wall.piece), wall.half + task_.half + task_.gap, {}};
    obstacle.box = Grown(obstacle.curve.box, obstacle.need);
    const auto stands_at = [&](const LinkEnd* end) {
      if (end == nullptr) return false;
      return std::any_of(end->rays.begin(), end->rays.end(), [&](const Ray& ray) {
        return DistanceTo(obstacle.curve, ray.point) < kStandsAt * obstacle.need;
      });
    };
    obstacle.at_from = stands_at(from);
    obstacle.at_to = stands_at(to);
    order_.push_back(obstacles_.size());
    obstacles_.push_back(obstacle);
  }

  void AddNode(const Turn& turn, glm::dvec2 way) {
    nodes_.push_back({turn, WeightOf(turn.radius), way});
  }

  void AddEnd(const LinkEnd& end) {
    for (const Ray& ray : end.rays) {
      if (end.is_dot) {
        AddDot(ray, end.goes_on);
        continue;
      }
      for (const double turn : kTurns) {
        for (const double sense : {1.0, -1.0}) {
          AddNode(TurnFrom(ray, sense * turn * task_.radius), ray.direction);
          nodes_.back().is_last_resort = !Fits(end, turn, sense);
        }
      }
    }
  }

  /// Away from a ring, and wide; tight within a letter, which leaves room to links that lead on
  /// from it.
  bool Fits(const LinkEnd& end, double turn, double sense) const {
    if (turn == kTurns[2]) return false;
    if (task_.one_letter) return turn == kTurns[0];
    if (!end.is_ring || end.rays.size() < 2) return true;
    const glm::dvec2 a = end.rays[0].direction, b = end.rays[1].direction;
    return turn == kTurns[1] && sense * (a.x * b.y - a.y * b.x) < 0;
  }

  /// Straight from a dot, and in a turn that begins in one of some directions.
  void AddDot(const Ray& ray, bool goes_on) {
    AddNode({ray.point, 0}, ray.direction);
    nodes_.back().narrows = goes_on;
    for (int i = 0; i < kDotRays; ++i) {
      const Ray turned{ray.point, DirectionOf(kTurn * i / kDotRays)};
      if (goes_on && glm::dot(turned.direction, ray.direction) < kLeastGoingOn) continue;
      for (const double turn : {kTurns[0], kTurns[1]}) {
        for (const double sense : {1.0, -1.0}) {
          AddNode(TurnFrom(turned, sense * turn * task_.radius), turned.direction);
          // no wall holds a tip in a dot: it leaves it on a sharp turn
          nodes_.back().is_last_resort = goes_on && turn == kTurns[0];
        }
      }
    }
  }

  void AddTurns(glm::dvec2 center, double radius) {
    if (!Contains(task_.room, center) || nodes_.size() > kMostNodes) return;
    for (std::size_t i = first_way_; i < nodes_.size(); ++i) {
      const Turn& other = nodes_[i].turn;
      if (glm::distance(other.center, center) + std::abs(std::abs(other.radius) - radius) <
          task_.half / 8) {
        return;
      }
    }
    AddNode({center, radius}, {1, 0});
    AddNode({center, -radius}, {1, 0});
  }

  /// Circles round the ends of a wall, unless it goes on there without a corner, and round the
  /// outside of a bend.
  void AddWaysRound(std::size_t wall) {
    if (obstacles_[wall].is_turned_round) return;
    obstacles_[wall].is_turned_round = true;
    const std::size_t begin = nodes_.size();
    const Obstacle& own = obstacles_[wall];
    AddTurnAt(own.curve.from, wall, wall - 1);
    AddTurnAt(own.curve.to, wall, wall + 1);
    if (own.curve.radius > 0) {
      AddTurns(own.curve.center, own.curve.radius + (1 + kHair) * own.need);
    }
    reached_.resize(nodes_.size());
    for (std::size_t i = 0; i < begin; ++i) {
      if (i < first_goal_ || reached_[i].to != kNone) Expand(i, begin, nodes_.size());
    }
  }

  /// Where nothing was found: with the turns kept back, and round everything.
  void LookFarther() {
    if (looks_farther_) return;
    looks_farther_ = true;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const bool begins = i < first_goal_ || reached_[i].to != kNone;
      for (std::size_t to = first_goal_; begins && to < nodes_.size(); ++to) {
        const bool is_new = nodes_[i].is_last_resort || nodes_[to].is_last_resort;
        if (is_new && reached_[to].to == kNone) Push(i, to);
      }
    }
    for (std::size_t i = 0; i < obstacles_.size(); ++i) AddWaysRound(i);
  }

  /// A turn round an end of a wall. Where the next one goes on from there without a corner it is
  /// wider, since both bulge beyond it, or none, since an arc has its own.
  void AddTurnAt(glm::dvec2 end, std::size_t wall, std::size_t next) {
    double share = kHair;
    if (next < obstacles_.size()) {
      const Curve& a = obstacles_[std::min(wall, next)].curve;
      const Curve& b = obstacles_[std::max(wall, next)].curve;
      const bool goes_on = glm::distance(a.to, b.from) < 1e-3 * task_.half;
      if (goes_on && glm::dot(WayAtEnd(a), WayAtStart(b)) > kNoCorner) {
        if (a.radius > 0 || b.radius > 0) return;
        share = kBesideCurve;
      }
    }
    AddTurns(end, std::max(task_.radius, (1 + share) * obstacles_[wall].need));
  }

  bool IsGoal(std::size_t node) const { return node >= first_goal_ && node < first_way_; }

  double ToGo(glm::dvec2 p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Ray& ray : task_.to.rays) least = std::min(least, glm::distance(ray.point, p));
    return least;
  }

  /// The way in which a circle is arrived at.
  glm::dvec2 WayInto(std::size_t node) const {
    return node < first_goal_ ? nodes_[node].way : reached_[node].way;
  }

  /// What a turn of a radian costs: its length, and more the sharper it is: a tip that is drawn
  /// round a bend presses against its outer wall. A half turn costs least at 2.4 of the least
  /// radii.
  double WeightOf(double radius) const {
    if (radius == 0) return 0;
    const double square = kTightness * task_.radius * task_.radius;
    return std::abs(radius) + square / std::abs(radius);
  }

  bool IsKeptBack(std::size_t node) const { return nodes_[node].is_last_resort && !looks_farther_; }

  void Expand(std::size_t from, std::size_t begin, std::size_t end) {
    if (IsKeptBack(from)) return;
    for (std::size_t to = begin; to < end; ++to) {
      if (to != from && reached_[to].to == kNone && !IsKeptBack(to)) Push(from, to);
    }
  }

  void Push(std::size_t from, std::size_t to) {
    const Node &a = nodes_[from], &b = nodes_[to];
    const bool starts = from < first_goal_, ends = IsGoal(to), is_direct = starts && ends;
    const Tangent tangent = TangentOf(a.turn, b.turn);
    if (!tangent.exists) return;
    const WideTurn& wide = is_direct ? kEndTurn : kWayTurn;
    const glm::dvec2 into = WayInto(from);
    if (wide.IsBelow(into, tangent.along, tangent.square, a.turn.radius)) return;
    // backwards, the last turn has the other sense
    if (ends && wide.IsBelow(b.way, tangent.along, tangent.square, -b.turn.radius)) return;
    const glm::dvec2 way = tangent.Way();
    if (a.narrows && glm::dot(a.way, way) < kLeastGoingOn) return;
    if (b.narrows && glm::dot(b.way, way) < kLeastGoingOn) return;
    const double first = RoughSweep(into, way, a.turn.radius);
    if (first > wide.widest || (starts && first > a.blocked + kRoughly)) return;
    Step step;
    step.from = from;
    step.to = to;
    step.way = way;
    step.cost = (starts ? 0 : reached_[from].cost) + first * a.weight + tangent.length;
    if (ends) {
      const double last = RoughSweep(way, b.way, b.turn.radius);
      if (last > wide.widest || last > b.blocked + kRoughly) return;
      step.cost += last * b.weight;
    }
    const double to_go = ends ? 0 : ToGo(b.turn.PointWhere(way));
    queue_.push_back({step.cost + kToGo * to_go, steps_.size()});
    steps_.push_back(step);
    std::push_heap(queue_.begin(), queue_.end());
  }

  /// Goes a step if it is free; whether the goal is reached by it.
  bool Take(Step step, std::vector<Piece>& path) {
    if (reached_[step.to].to != kNone) return false;
    if (!IsClear(step)) return false;
    if (IsGoal(step.to)) {
      path = PathTo(step);
      return KeepsFromItself(path);
    }
    reached_[step.to] = step;
    Expand(step.to, first_goal_, nodes_.size());
    return false;
  }

  std::vector<Piece> PiecesOf(const Step& step) const {
    const Node &a = nodes_[step.from], &b = nodes_[step.to];
    const glm::dvec2 into = WayInto(step.from);
    const glm::dvec2 out = IsGoal(step.to) && b.turn.radius != 0 ? b.way : step.way;
    return ArcLineArc({a.turn.PointWhere(into), into}, {b.turn.PointWhere(out), out}, a.turn.radius,
                      b.turn.radius);
  }

  /// Notes what is in the way.
  bool IsClear(const Curve& curve, bool near_from, bool near_to) {
    for (std::size_t& i : order_) {
      const Obstacle& obstacle = obstacles_[i];
      if (!AreNear(obstacle.box, curve.box)) continue;
      if ((near_from && obstacle.at_from) || (near_to && obstacle.at_to)) continue;
      if (DistanceBetween(obstacle.curve, curve) >= obstacle.need) continue;
      blocker_ = i;
      std::swap(i, order_.front());  // what is in the way of one is mostly in that of the next
      return false;
    }
    return true;
  }

  /// Whether the way of a step keeps clear; writes its length. The line first, since it costs least
  /// to look at.
  bool IsClear(Step& step) {
    Node &a = nodes_[step.from], &b = nodes_[step.to];
    const bool starts = step.from < first_goal_, ends = IsGoal(step.to);
    const glm::dvec2 into = WayInto(step.from), out = ends ? b.way : step.way;
    const double first = SweepBetween(into, step.way, a.turn.radius);
    const double last = SweepBetween(step.way, out, b.turn.radius);
    if (starts && std::abs(first) >= a.blocked) return false;
    if (ends && std::abs(last) >= b.blocked) return false;
    const glm::dvec2 begin = a.turn.PointWhere(step.way), end = b.turn.PointWhere(step.way);
    const Part line = {LineCurve(begin, end), 0, glm::distance(begin, end)};
    const double line_from =
        (starts ? 0 : reached_[step.from].length) + std::abs(first * a.turn.radius);
    const double line_to = line_from + line.length;
    step.length = line_to + std::abs(last * b.turn.radius);
    const double to_end = ends ? step.length : std::numeric_limits<double>::infinity();
    if (!IsClear(line, line_from, to_end)) return false;
    if (!starts || std::abs(first) > a.free) {
      const Part part = TurnPart(a.turn, into, step.way, first);
      const bool clear = IsClear(part, line_from - part.length, to_end);
      // a longer turn from there has this one in it
      if (starts) (clear ? a.free : a.blocked) = std::abs(first);
      if (!clear) return false;
    }
    if (std::abs(last) <= b.free) return true;
    const bool clear = IsClear(TurnPart(b.turn, step.way, out, last), line_to, to_end);
    // the first part's walls do not count here: no more is known of later ones
    if (line_to >= task_.from.own) (clear ? b.free : b.blocked) = std::abs(last);
    return clear;
  }

  /// Whether a part keeps clear that begins `before` from the link's start, which is `whole` long.
  bool IsClear(const Part& part, double before, double whole) {
    const double length = part.length;
    if (length <= 1e-9 * task_.half) return true;
    double cuts[] = {0, std::clamp(task_.from.own - before, 0.0, length),
                     std::clamp(whole - task_.to.own - before, 0.0, length), length};
    if (cuts[1] > cuts[2]) std::swap(cuts[1], cuts[2]);
    for (int i = 0; i < 3; ++i) {
      const double own = cuts[i + 1] - cuts[i];
      if (own <= 1e-9 * task_.half) continue;
      const double middle = before + 0.5 * (cuts[i] + cuts[i + 1]);
      const Part cut = own < length ? Between(part, cuts[i], cuts[i + 1]) : part;
      if (!Contains(task_.room, cut.curve.box.min) || !Contains(task_.room, cut.curve.box.max)) {
        return false;
      }
      const bool near_from = middle < task_.from.own;
      if (!IsClear(cut.curve, near_from, middle > whole - task_.to.own)) return false;
      if (!near_from && RunsAlong(cut)) return false;
    }
    return true;
  }

  /// Whether it is near to a link that it may cross, but not steeply.
  bool RunsAlong(const Part& part) const {
    const double near = 2 * task_.half, spacing = task_.half / 2;
    const int steps = 1 + static_cast<int>(part.length / spacing);
    for (std::size_t i = 0; i < crossed_.size(); ++i) {
      if (!Overlap(Grown(crossed_[i].box, near), part.curve.box)) continue;
      if (DistanceBetween(crossed_[i], part.curve) >= near) continue;
      const Piece& other = task_.links[i];
      const double own = Length(other);
      const int count = 1 + static_cast<int>(own / spacing);
      for (int n = 0; n <= count; ++n) {
        const glm::dvec2 p = PointAt(other, own * n / count);
        const glm::dvec2 way = TangentAt(other, own * n / count);
        for (int m = 0; m < steps; ++m) {
          // the short line in place of a short arc
          const Curve here =
              Between(part, part.length * m / steps, part.length * (m + 1) / steps).curve;
          const glm::dvec2 along = here.to - here.from;
          if (glm::distance(0.5 * (here.from + here.to), p) > near) continue;
          const double sine = (along.x * way.y - along.y * way.x) / glm::length(along);
          if (std::abs(sine) < kLeastCrossing) return true;
        }
      }
    }
    return false;
  }

  std::vector<Piece> PathTo(const Step& last) const {
    std::vector<Step> steps = {last};
    while (steps.back().from >= first_way_) steps.push_back(reached_[steps.back().from]);
    std::vector<Piece> path;
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
      for (const Piece& piece : PiecesOf(*step)) path.push_back(piece);
    }
    return path;
  }

  /// Whether pieces that do not follow each other, or an arc's ends, are nearer than `apart`.
  static bool MayComeNear(const std::vector<Curve>& curves, double apart) {
    for (std::size_t i = 0; i < curves.size(); ++i) {
      if (curves[i].is_long && glm::distance(curves[i].from, curves[i].to) < apart) return true;
      for (std::size_t j = i + 2; j < curves.size(); ++j) {
        if (DistanceBetween(curves[i], curves[j]) < apart) return true;
      }
    }
    return false;
  }

  /// Points farther apart along the way than a half turn at the distance wanted are not nearer than
  /// it.
  bool KeepsFromItself(const std::vector<Piece>& path) const {
    const double apart = 2 * task_.half + task_.gap;
    double turned = 0, left = 0, right = 0;
    for (const Piece& piece : path) {
      if (const std::optional<Arc> arc = ArcOf(piece)) turned += arc->sweep;
      left = std::max(left, turned);
      right = std::min(right, turned);
    }
    // whose directions lie within half a turn, that goes on in one of them and never comes back
    if (left - right < kTurn / 2) return true;
    if (!MayComeNear(CurvesOf(path), apart)) return true;
    const double spacing = apart / 3;
    std::vector<glm::dvec2> points;
    for (const Piece& piece : path) {
      const double length = Length(piece);
      const auto count = static_cast<int>(std::ceil(length / spacing));
      for (int i = 0; i < count; ++i) points.push_back(PointAt(piece, length * i / count));
    }
    const auto skip = static_cast<std::size_t>(std::ceil(1.7 * apart / spacing));
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = i + skip; j < points.size(); ++j) {
        const glm::dvec2 between = points[j] - points[i];
        if (glm::dot(between, between) < apart * apart) return false;
      }
    }
    return true;
  }

  const LinkTask& task_;
  std::vector<Obstacle> obstacles_;
  std::vector<std::size_t> order_;  ///< of them, in which they are looked at
  std::vector<Curve> crossed_;
  std::vector<Node> nodes_;  ///< starts, goals, ways round
  std::size_t first_goal_ = 0, first_way_ = 0;
  std::vector<Step> reached_;  ///< by what; none while that has no end
  std::vector<Step> steps_;    ///< that were thought of
  std::vector<Entry> queue_;   ///< of those to be tried, a heap
  std::size_t blocker_ = kNone;
  bool looks_farther_ = false;
};

}  // namespace

std::vector<Piece> ArcLineArc(const Ray& from, const Ray& to, double from_radius,
                              double to_radius) {
  const Turn first = TurnFrom(from, from_radius), last = TurnFrom(to, to_radius);
  const Tangent tangent = TangentOf(first, last);
  std::vector<Piece> pieces;
  if (!tangent.exists) return pieces;
  const glm::dvec2 way = tangent.Way();
  WriteTurn(first, from.point, SweepBetween(from.direction, way, from_radius), pieces);
  const double none = 1e-9 * (tangent.length + std::abs(from_radius) + std::abs(to_radius));
  const glm::dvec2 end = last.PointWhere(way);
  if (tangent.length > none) pieces.push_back(Line{first.PointWhere(way), end});
  WriteTurn(last, end, SweepBetween(way, to.direction, to_radius), pieces);
  return pieces;
}

std::vector<Piece> FindLink(const LinkTask& task) { return LinkSearch(task).Run(); }

double LeastGap(const std::vector<Piece>& path, double half, const LinkWall& wall,
                double skip_begin, double skip_end, double step) {
  const double whole = Length(path);
  double least = std::numeric_limits<double>::infinity(), begin = 0;
  for (const Piece& piece : path) {
    const double length = Length(piece);
    for (double s = 0; s <= length; s += step) {
      if (begin + s < skip_begin || whole - begin - s < skip_end) continue;
      least = std::min(least, DistanceTo(wall.piece, PointAt(piece, s)) - wall.half - half);
    }
    begin += length;
  }
  return least;
}

}  // namespace moontrace
