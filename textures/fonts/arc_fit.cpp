#include "textures/fonts/arc_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>

#include "textures/base/overload.h"
#include "textures/base/units.h"

namespace moontrace {
namespace {

constexpr int kDeepest = 12;              ///< halvings of the range of t
constexpr std::size_t kLongestRun = 32;   ///< pieces that may become one; bounds the time
constexpr double kSameCircle = 1e-9;      ///< of the radius: equal but for rounding
constexpr double kWholeTurnSlack = 1e-6;  ///< [rad]

double Cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

/// Direction of travel at `t`, looking towards `towards` where the derivative vanishes.
glm::dvec2 DirectionAt(const Curve& curve, double t, double towards) {
  const glm::dvec2 chord = curve.point(towards) - curve.point(t);
  const glm::dvec2 derivative = curve.derivative(t);
  const double speed = glm::length(derivative);
  // Below this share of the chord's own speed the derivative is rounding noise.
  if (speed * std::abs(towards - t) > 1e-6 * glm::length(chord)) return derivative / speed;
  const double sense = towards > t ? 1 : -1;
  const glm::dvec2 step = sense * (curve.point(t + 1e-3 * (towards - t)) - curve.point(t));
  const double length = glm::length(step);
  return length > 0 ? step / length : glm::dvec2(1.0, 0.0);
}

/// Both arcs of the biarc from p along `u` to q along `v` (unit vectors).
void AppendBiarc(glm::dvec2 p, glm::dvec2 u, glm::dvec2 q, glm::dvec2 v, double flat,
                 std::vector<Piece>& pieces) {
  const glm::dvec2 chord = q - p;
  const glm::dvec2 sum = u + v;
  const double b = glm::dot(chord, sum);
  const double chord2 = glm::dot(chord, chord);
  // Tangent length d of both arcs: |chord - d sum| = 2 d, the root that stays stable for u = v.
  const double d =
      chord2 / (b + std::sqrt(std::max(0.0, b * b + 2 * (1 - glm::dot(u, v)) * chord2)));
  const glm::dvec2 joint = 0.5 * (p + q + d * (u - v));
  const Piece first = ArcByTangent(p, u, joint, flat);
  pieces.push_back(first);
  pieces.push_back(ArcByTangent(joint, TangentAt(first, Length(first)), q, flat));
}

bool Fits(const Curve& curve, double from, double to, const Piece& a, const Piece& b,
          double tolerance) {
  constexpr int kSamples = 12;
  constexpr double kMargin = 0.9;  // for what lies between the samples
  for (int i = 1; i < kSamples; ++i) {
    const glm::dvec2 p = curve.point(from + (to - from) * i / kSamples);
    if (!(std::min(DistanceTo(a, p), DistanceTo(b, p)) <= kMargin * tolerance)) return false;
  }
  return true;
}

bool IsTiny(const Curve& curve, double from, double to, double size) {
  const glm::dvec2 p = curve.point(from);
  for (int i = 1; i <= 4; ++i) {
    if (glm::length(curve.point(from + (to - from) * i / 4) - p) > size) return false;
  }
  return true;
}

void FitRange(const Curve& curve, double from, double to, int depth, double tolerance,
              std::vector<Piece>& pieces) {
  const glm::dvec2 p = curve.point(from), q = curve.point(to);
  const glm::dvec2 chord = q - p;
  const double length = glm::length(chord);
  // Points, doubled points and the neighbourhood of cusps would be halved in vain.
  if (depth == kDeepest || IsTiny(curve, from, to, 1e-3 * tolerance)) {
    if (length > 0) pieces.emplace_back(Line{p, q});
    return;
  }
  if (length > 0) {
    const glm::dvec2 u = DirectionAt(curve, from, to), v = DirectionAt(curve, to, from);
    // A biarc is well behaved while both tangents lie within 60 degrees of the chord.
    if (glm::dot(u, chord) > 0.5 * length && glm::dot(v, chord) > 0.5 * length) {
      std::vector<Piece> pair;
      AppendBiarc(p, u, q, v, 1e-3 * tolerance, pair);
      if (Fits(curve, from, to, pair[0], pair[1], tolerance)) {
        pieces.insert(pieces.end(), pair.begin(), pair.end());
        return;
      }
    }
  }
  const double middle = 0.5 * (from + to);
  FitRange(curve, from, middle, depth + 1, tolerance, pieces);
  FitRange(curve, middle, to, depth + 1, tolerance, pieces);
}

/// Consecutive pieces that one piece may replace.
struct Run {
  std::vector<Piece> pieces;
  Piece joined;
};

/// Centre of the circle through three points, or nothing for points on a line.
std::optional<glm::dvec2> CenterOf(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  const glm::dvec2 ab = b - a, ac = c - a;
  const double area2 = 2 * Cross(ab, ac);
  if (std::abs(area2) <= 1e-12 * glm::dot(ac, ac)) return std::nullopt;
  const double ab2 = glm::dot(ab, ab), ac2 = glm::dot(ac, ac);
  return a + glm::dvec2(ac.y * ab2 - ab.y * ac2, ab.x * ac2 - ac.x * ab2) / area2;
}

double Angle(glm::dvec2 v) { return std::atan2(v.y, v.x); }

/// One arc through first, middle and last point of the pieces; the whole circle when these close.
std::optional<Arc> ArcThrough(const std::vector<Piece>& pieces, double total_sweep,
                              double tolerance) {
  const double length = Length(pieces);
  const glm::dvec2 first = StartOf(pieces.front()), last = EndOf(pieces.back());
  const bool closed = glm::length(last - first) <= tolerance && std::abs(total_sweep) > kTurn / 2;
  const std::optional<glm::dvec2> center =
      closed ? CenterOf(first, PointAlong(pieces, length / 3), PointAlong(pieces, 2 * length / 3))
             : CenterOf(first, PointAlong(pieces, length / 2), last);
  if (!center) return std::nullopt;
  Arc arc{*center, glm::length(first - *center), Angle(first - *center), 0};
  const double sense = total_sweep < 0 ? -1 : 1;
  const double turned = std::fmod(sense * (Angle(last - *center) - arc.start), kTurn);
  arc.sweep = sense * (closed ? kTurn : turned > 0 ? turned : turned + kTurn);
  return arc;
}

bool LiesOn(const Arc& arc, const std::vector<Piece>& pieces, double tolerance) {
  constexpr int kSamples = 8;
  for (const Piece& piece : pieces) {
    for (int i = 0; i <= kSamples; ++i) {
      const glm::dvec2 p = PointAt(piece, Length(piece) * i / kSamples);
      if (!(std::abs(glm::length(p - arc.center) - arc.radius) <= tolerance)) return false;
    }
  }
  return true;
}

std::optional<Piece> JoinedArc(const Run& run, const Arc& next, double tolerance) {
  const Arc& before = std::get<Arc>(run.joined);
  double sweep = before.sweep + next.sweep;
  if ((before.sweep < 0) != (next.sweep < 0) || std::abs(sweep) > kTurn + kWholeTurnSlack) {
    return std::nullopt;
  }
  if (glm::length(before.center - next.center) <= kSameCircle * before.radius &&
      std::abs(before.radius - next.radius) <= kSameCircle * before.radius) {
    if (std::abs(sweep) > kTurn - kWholeTurnSlack) sweep = std::copysign(kTurn, sweep);
    return Arc{before.center, before.radius, before.start, sweep};
  }
  std::vector<Piece> pieces = run.pieces;
  pieces.emplace_back(next);
  const std::optional<Arc> arc = ArcThrough(pieces, sweep, tolerance);
  // Both turns must agree, or the arc would run round the circle's other side.
  if (!arc || std::abs(arc->sweep - sweep) > 0.5) return std::nullopt;
  return LiesOn(*arc, pieces, tolerance) ? std::optional<Piece>(*arc) : std::nullopt;
}

std::optional<Piece> JoinedLine(const Run& run, const Line& next, double tolerance) {
  const Line joined{std::get<Line>(run.joined).from, next.to};
  for (const Piece& piece : run.pieces) {
    if (DistanceTo(joined, std::get<Line>(piece).to) > tolerance) return std::nullopt;
  }
  return joined;
}

std::optional<Piece> Joined(const Run& run, const Piece& next, double tolerance) {
  if (run.pieces.size() >= kLongestRun || run.joined.index() != next.index()) return std::nullopt;
  const glm::dvec2 before = TangentAt(run.joined, Length(run.joined));
  if (glm::dot(before, TangentAt(next, 0)) < 0.9) return std::nullopt;
  return std::visit(
      Overload{
          [&run, tolerance](const Line& line) { return JoinedLine(run, line, tolerance); },
          [&run, tolerance](const Arc& arc) { return JoinedArc(run, arc, tolerance); },
      },
      next);
}

}  // namespace

Curve CubicCurve(glm::dvec2 p0, glm::dvec2 p1, glm::dvec2 p2, glm::dvec2 p3) {
  return {[=](double t) {
            const double s = 1 - t;
            return s * s * s * p0 + 3 * s * s * t * p1 + 3 * s * t * t * p2 + t * t * t * p3;
          },
          [=](double t) {
            const double s = 1 - t;
            return 3.0 * (s * s * (p1 - p0) + 2 * s * t * (p2 - p1) + t * t * (p3 - p2));
          }};
}

Piece ArcByTangent(glm::dvec2 p, glm::dvec2 tangent, glm::dvec2 q, double flat) {
  const glm::dvec2 chord = q - p;
  const double sine = Cross(tangent, chord);  // length times the sine of half the sweep
  const double half = std::atan2(sine, glm::dot(tangent, chord));
  if (0.5 * glm::length(chord) * std::abs(std::tan(0.5 * half)) <= flat) return Line{p, q};
  const double radius = 0.5 * glm::dot(chord, chord) / sine;  // below zero: turns right
  const glm::dvec2 center = p + radius * glm::dvec2(-tangent.y, tangent.x);
  return Arc{center, std::abs(radius), Angle(p - center), 2 * half};
}

std::vector<Piece> FitArcs(const Curve& curve, double tolerance) {
  std::vector<Piece> pieces;
  FitRange(curve, 0, 1, 0, tolerance, pieces);
  return pieces;
}

std::vector<Piece> MergePieces(const std::vector<Piece>& pieces, double tolerance) {
  std::vector<Piece> merged;
  Run run;
  for (const Piece& piece : pieces) {
    if (!run.pieces.empty()) {
      if (const std::optional<Piece> joined = Joined(run, piece, tolerance)) {
        run.joined = *joined;
        run.pieces.push_back(piece);
        continue;
      }
      merged.push_back(run.joined);
    }
    run = Run{{piece}, piece};
  }
  if (!run.pieces.empty()) merged.push_back(run.joined);
  return merged;
}

}  // namespace moontrace
