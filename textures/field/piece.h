#pragma once

#include <cmath>
#include <glm/vec2.hpp>
#include <optional>
#include <variant>
#include <vector>

namespace moontrace {

/// An axis-aligned rectangle; empty while min > max.
struct Box {
  glm::dvec2 min{1e300, 1e300};
  glm::dvec2 max{-1e300, -1e300};
  bool operator==(const Box&) const = default;
};
void Include(Box& box, glm::dvec2 p);
void Include(Box& box, const Box& other);
Box Grown(const Box& box, double by);
Box Moved(const Box& box, glm::dvec2 by);
bool Contains(const Box& box, glm::dvec2 p) noexcept;
bool Overlap(const Box& a, const Box& b) noexcept;

/// The unit vector at an angle [rad] from the x axis, counter-clockwise.
inline glm::dvec2 DirectionOf(double angle) noexcept { return {std::cos(angle), std::sin(angle)}; }

/// A straight line between two points, butt ends: it covers only points whose foot lies on it.
struct Line {
  glm::dvec2 from{0, 0};
  glm::dvec2 to{0, 0};
  bool operator==(const Line&) const = default;
};

/// A piece of a circle from angle `start` through `sweep` [rad], counter-clockwise positive, butt
/// ends. |sweep| >= 2 pi is the whole circle.
struct Arc {
  glm::dvec2 center{0, 0};
  double radius = 0;  ///< > 0
  double start = 0;
  double sweep = 0;
  bool operator==(const Arc&) const = default;
};

bool IsWhole(const Arc& arc) noexcept;
/// The arc's sweep, at most a turn to either side: a whole circle ends where it starts, however far
/// beyond a turn its own sweep says.
double SweepOf(const Arc& arc) noexcept;
/// How far the direction of `v` lies from the angle `start` in the sense of `sense` (1
/// counter-clockwise, -1 clockwise): in [0, 2 pi], a turn only where rounding makes it one.
double AngleFrom(double start, double sense, glm::dvec2 v) noexcept;
/// The same from the arc's start in its own sense; `v` from its centre.
double AngleAlong(const Arc& arc, glm::dvec2 v) noexcept;

/// A piece of a stroke or of an outline, travelled from its first point to its last.
using Piece = std::variant<Line, Arc>;

/// The piece if it is an arc. For what concerns arcs alone; what tells all kinds apart visits them.
std::optional<Arc> ArcOf(const Piece& piece);
glm::dvec2 StartOf(const Piece& piece);
glm::dvec2 EndOf(const Piece& piece);
double Length(const Piece& piece);
/// Of all pieces together.
double Length(const std::vector<Piece>& pieces);
/// Point at arc length `s` from the start, held to the piece.
glm::dvec2 PointAt(const Piece& piece, double s);
/// Point at arc length `s` of pieces that follow each other, at least one; beyond all the last's
/// end.
glm::dvec2 PointAlong(const std::vector<Piece>& pieces, double s);
/// Unit direction of travel at arc length `s`.
glm::dvec2 TangentAt(const Piece& piece, double s);
/// The point of the piece that is nearest to `p`, its ends included.
glm::dvec2 NearestOn(const Piece& piece, glm::dvec2 p);
/// Distance of `p` to that point.
double DistanceTo(const Piece& piece, glm::dvec2 p);
/// The part of a piece of some length from one arc length to another, both on it; travelled
/// backwards if the second is the less.
Piece PartBetween(const Piece& piece, double from, double to);
/// The piece scaled about the origin and then moved.
Piece Placed(const Piece& piece, double scale, glm::dvec2 origin);
Box BoundsOf(const Piece& piece);

}  // namespace moontrace
