#include "textures/relief/link.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <queue>

#include "textures/base/units.h"

namespace moontrace {
namespace {

constexpr double kNoTurn = 1e-7;          // [rad]; what rounding leaves of a turn that is none
constexpr double kTurns[] = {1, 2, 4};    // in least radii
constexpr std::size_t kMostTries = 3000;  // bounds the time of a hopeless task
constexpr double kLeastCrossing = 0.643;  // sine of 40 degrees
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

glm::dvec2 LeftOf(glm::dvec2 v) { return {-v.y, v.x}; }

/// The two turns and the straight part between them.
struct Parts {
  bool exists = false;
  glm::dvec2 from_center{0, 0}, to_center{0, 0};
  glm::dvec2 straight{0, 0};            // unit
  double from_sweep = 0, to_sweep = 0;  // signed
  double length = 0;                    // of the straight part
  double whole = 0;
};

/// The turn from one direction to another in the sense of `radius`.
double SweepBetween(glm::dvec2 from, glm::dvec2 to, double radius) {
  const double angle = std::atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
  double sweep = radius > 0 ? angle : -angle;
  if (sweep < 0) sweep += kTurn;
  if (sweep < kNoTurn || sweep > kTurn - kNoTurn) sweep = 0;
  return radius > 0 ? sweep : -sweep;
}

Parts PartsOf(const Ray& from, const Ray& to, double from_radius, double to_radius) {
  Parts parts;
  parts.from_center = from.point + from_radius * LeftOf(from.direction);
  parts.to_center = to.point + to_radius * LeftOf(to.direction);
  // The common tangent: it lies `from_radius` to the right of one centre, `to_radius` of the other.
  const glm::dvec2 v = parts.to_center - parts.from_center;
  const double k = to_radius - from_radius;
  const double square = glm::dot(v, v), left = square - k * k;
  if (!(square > 0 && left >= 0)) return parts;
  parts.length = std::sqrt(left);
  parts.straight = glm::normalize((parts.length * v - k * LeftOf(v)) / square);
  parts.from_sweep = SweepBetween(from.direction, parts.straight, from_radius);
  parts.to_sweep = SweepBetween(parts.straight, to.direction, to_radius);
  parts.whole = std::abs(from_radius * parts.from_sweep) + parts.length +
                std::abs(to_radius * parts.to_sweep);
  parts.exists = parts.whole > 0;
  return parts;
}

/// The arc that begins at `p` on the circle.
Arc ArcFrom(glm::dvec2 center, double radius, glm::dvec2 p, double sweep) {
  return {center, std::abs(radius), std::atan2(p.y - center.y, p.x - center.x), sweep};
}

/// A wall with what rules most of it out at once.
struct Obstacle {
  LinkWall wall;
  Box box;
  bool at_from = false, at_to = false;  ///< stands at the link's own ends: see FindLink
};

double DistanceOf(const Box& box, glm::dvec2 p) {
  const glm::dvec2 out = glm::max(glm::max(box.min - p, p - box.max), glm::dvec2(0, 0));
  return glm::length(out);
}

class LinkSearch {
 public:
  explicit LinkSearch(const LinkTask& task)
      : task_(task), need_(task.half + task.gap), step_(need_ / 8) {
    for (const LinkWall& wall : task.from.walls) {
      Add(wall, &task.from, task.one_letter ? &task.to : nullptr);
    }
    for (const LinkWall& wall : task.to.walls) Add(wall, nullptr, &task.to);
    for (const LinkWall& wall : task.others) Add(wall, nullptr, nullptr);
    for (const Ray& ray : task.from.rays) nodes_.push_back(ray);
    first_goal_ = nodes_.size();
    for (const Ray& ray : task.to.rays) nodes_.push_back(ray);
    first_way_ = nodes_.size();
    for (const Ray& ray : task.ways) {
      if (Contains(task.room, ray.point) && IsClear(ray.point, false, false)) nodes_.push_back(ray);
    }
    reached_.resize(nodes_.size());
  }

  std::vector<Piece> Run() {
    for (std::size_t i = 0; i < first_goal_; ++i) Expand(i, 0);
    for (std::size_t tries = 0; !queue_.empty() && tries < kMostTries; ++tries) {
      const Step step = queue_.top();
      queue_.pop();
      if (reached_[step.to].done) continue;
      const std::vector<Piece> pieces =
          ArcLineArc(nodes_[step.from], nodes_[step.to], step.from_radius, step.to_radius);
      const double before = step.length - Length(pieces);
      if (!IsClear(pieces, before, IsGoal(step.to))) continue;
      if (IsGoal(step.to)) {
        std::vector<Piece> path = PathTo(step);
        if (KeepsFromItself(path)) return path;
        continue;
      }
      reached_[step.to] = {true, step};
      Expand(step.to, step.length);
    }
    return {};
  }

 private:
  struct Step {
    double bound = 0;   ///< length so far and the least that is to come [m]
    double length = 0;  ///< from the link's start to this step's end [m]
    std::size_t from = kNone, to = kNone;
    double from_radius = 0, to_radius = 0;
    bool operator<(const Step& other) const { return bound > other.bound; }
  };
  struct Reached {
    bool done = false;
    Step by;
  };

  void Add(const LinkWall& wall, const LinkEnd* from, const LinkEnd* to) {
    Obstacle obstacle{wall, BoundsOf(wall.piece)};
    const auto stands_at = [&](const LinkEnd* end) {
      if (end == nullptr) return false;
      for (const Ray& ray : end->rays) {
        if (DistanceTo(wall.piece, ray.point) - wall.half < need_ + step_) return true;
      }
      return false;
    };
    obstacle.at_from = stands_at(from);
    obstacle.at_to = stands_at(to);
    obstacles_.push_back(obstacle);
  }

  bool IsGoal(std::size_t node) const { return node >= first_goal_ && node < first_way_; }

  double ToGo(glm::dvec2 p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Ray& ray : task_.to.rays) least = std::min(least, glm::distance(ray.point, p));
    return least;
  }

  void Expand(std::size_t from, double length) {
    const bool start = from < first_goal_;
    for (std::size_t to = first_goal_; to < nodes_.size(); ++to) {
      if (to == from || reached_[to].done) continue;
      for (const double a : kTurns) {
        for (const double b : kTurns) {
          // Between ways the sharpest turns suffice: they need the least room.
          if ((!start && a != kTurns[0]) || (!IsGoal(to) && b != kTurns[0])) continue;
          for (int sense = 0; sense < 4; ++sense) {
            Push(from, to, length, (sense & 1 ? -a : a) * task_.radius,
                 (sense & 2 ? -b : b) * task_.radius);
          }
        }
      }
    }
  }

  void Push(std::size_t from, std::size_t to, double length, double from_radius, double to_radius) {
    const double own = ArcLineArcLength(nodes_[from], nodes_[to], from_radius, to_radius);
    if (!std::isfinite(own)) return;
    const double bound = length + own + ToGo(nodes_[to].point);
    queue_.push({bound, length + own, from, to, from_radius, to_radius});
  }

  /// Least distance to the walls that count, rim of the wall to the point.
  double Clearance(glm::dvec2 p, bool near_from, bool near_to) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Obstacle& obstacle : obstacles_) {
      if ((near_from && obstacle.at_from) || (near_to && obstacle.at_to)) continue;
      if (DistanceOf(obstacle.box, p) - obstacle.wall.half >= least) continue;
      least = std::min(least, DistanceTo(obstacle.wall.piece, p) - obstacle.wall.half);
    }
    return least;
  }
  bool IsClear(glm::dvec2 p, bool near_from, bool near_to) const {
    return Clearance(p, near_from, near_to) >= need_ + step_ / 2;
  }

  bool RunsAlong(const Ray& here) const {
    for (const Ray& ray : task_.crossed) {
      if (glm::distance(ray.point, here.point) > 2 * task_.half) continue;
      const glm::dvec2 a = ray.direction, b = here.direction;
      if (std::abs(a.x * b.y - a.y * b.x) < kLeastCrossing) return true;
    }
    return false;
  }

  /// Whether the pieces keep clear; they begin `before` from the link's start. Distance changes no
  /// faster than the point moves, so where walls are far, steps are long; the shortest step's half
  /// is kept clear in addition, so that no point between is nearer than it may be.
  bool IsClear(const std::vector<Piece>& pieces, double before, bool ends) const {
    const double whole = Length(pieces);
    double begin = 0;
    for (const Piece& piece : pieces) {
      const Box box = BoundsOf(piece);
      if (!Contains(task_.room, box.min) || !Contains(task_.room, box.max)) return false;
      const double length = Length(piece);
      for (double s = 0;;) {
        const double from_start = before + begin + s, to_end = whole - begin - s;
        const bool near_from = from_start < task_.from.own;
        const bool near_to = ends && to_end < task_.to.own;
        const double clear = Clearance(PointAt(piece, s), near_from, near_to);
        if (clear < need_ + step_ / 2) return false;
        if (!near_from && RunsAlong({PointAt(piece, s), TangentAt(piece, s)})) return false;
        if (s >= length) break;
        double ahead = std::max(step_, task_.crossed.empty() ? clear - need_ : 0);
        // not beyond where walls begin to count
        if (near_from) ahead = std::min(ahead, task_.from.own - from_start + 1e-3 * step_);
        s = std::min(s + ahead, length);
      }
      begin += length;
    }
    return true;
  }

  std::vector<Piece> PathTo(const Step& last) const {
    std::vector<Step> steps = {last};
    while (steps.back().from >= first_way_) steps.push_back(reached_[steps.back().from].by);
    std::vector<Piece> path;
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
      for (const Piece& piece :
           ArcLineArc(nodes_[step->from], nodes_[step->to], step->from_radius, step->to_radius)) {
        path.push_back(piece);
      }
    }
    return path;
  }

  /// Points farther apart along the way than a half turn at the distance wanted are not nearer than
  /// it.
  bool KeepsFromItself(const std::vector<Piece>& path) const {
    const double apart = 2 * task_.half + task_.gap;
    const double spacing = apart / 4;
    std::vector<glm::dvec2> points;
    for (const Piece& piece : path) {
      const double length = Length(piece);
      const auto count = static_cast<int>(std::ceil(length / spacing));
      for (int i = 0; i < count; ++i) points.push_back(PointAt(piece, length * i / count));
    }
    const auto skip = static_cast<std::size_t>(std::ceil(1.7 * apart / spacing));
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = i + skip; j < points.size(); ++j) {
        if (glm::distance(points[i], points[j]) < apart) return false;
      }
    }
    return true;
  }

  const LinkTask& task_;
  double need_ = 0;  ///< from a wall's rim to the link's centre line [m]
  double step_ = 0;  ///< shortest between points looked at [m]
  std::vector<Obstacle> obstacles_;
  std::vector<Ray> nodes_;  ///< starts, goals, ways
  std::size_t first_goal_ = 0, first_way_ = 0;
  std::vector<Reached> reached_;
  std::priority_queue<Step> queue_;
};

}  // namespace

double ArcLineArcLength(const Ray& from, const Ray& to, double from_radius, double to_radius) {
  const Parts parts = PartsOf(from, to, from_radius, to_radius);
  return parts.exists ? parts.whole : std::numeric_limits<double>::infinity();
}

std::vector<Piece> ArcLineArc(const Ray& from, const Ray& to, double from_radius,
                              double to_radius) {
  const Parts parts = PartsOf(from, to, from_radius, to_radius);
  std::vector<Piece> pieces;
  if (!parts.exists) return pieces;
  const glm::dvec2 right = -LeftOf(parts.straight);
  const glm::dvec2 begin =
      parts.from_sweep == 0 ? from.point : parts.from_center + from_radius * right;
  const glm::dvec2 end = parts.to_sweep == 0 ? to.point : parts.to_center + to_radius * right;
  if (parts.from_sweep != 0) {
    pieces.push_back(ArcFrom(parts.from_center, from_radius, from.point, parts.from_sweep));
  }
  const double none = 1e-9 * parts.whole;
  if (parts.length > none) pieces.push_back(Line{begin, end});
  if (parts.to_sweep != 0) {
    pieces.push_back(ArcFrom(parts.to_center, to_radius, end, parts.to_sweep));
  }
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
