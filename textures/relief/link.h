#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "textures/field/element.h"

namespace moontrace {

/// A place and a direction of travel through it.
struct Ray {
  glm::dvec2 point{0, 0};      ///< [m]
  glm::dvec2 direction{1, 0};  ///< unit
};

/// The way from one ray to another that turns on a circle, goes straight and turns on a second
/// circle (the outer four of Dubins' ways, 1957, here with two radii). Radii [m] are signed: above
/// zero the circle is travelled counter-clockwise, of zero it is a point where the direction is
/// free. The first piece leaves in `from`'s direction,
/// the last arrives in `to`'s, joints have no corner. Pieces of no length are left out. Empty
/// where the circles lie so that there is no such way, and between equal rays.
std::vector<Piece> ArcLineArc(const Ray& from, const Ray& to, double from_radius, double to_radius);

/// What a link keeps clear of: a stroke's centre line with half its groove's width (of an outline,
/// zero).
struct LinkWall {
  Piece piece;
  double half = 0;  ///< [m]
};

/// Where a link can begin or end: at an open stroke's end there is one ray; a ring is left and
/// entered anywhere, in its direction of travel, at one of many rays.
struct LinkEnd {
  std::vector<Ray> rays;
  std::vector<LinkWall> walls;  ///< of the letter that it belongs to
  double own = 0;  ///< length of the link's first (last) part, near to its own letter [m]
  bool is_ring = false;
  /// A dot, its middle the only ray's point: left and entered in any direction,
  bool is_dot = false;
  bool goes_on = false;  ///< or within 60 degrees of the ray's.
};

/// Everything that decides a link, in one frame. Lengths in metres.
struct LinkTask {
  LinkEnd from, to;
  bool one_letter = false;       ///< both ends are of one letter: `from`'s walls are its
  std::vector<LinkWall> others;  ///< of further letters
  std::vector<Piece> links;      ///< centre lines of further links of this width
  bool may_cross = false;        ///< those: if steeply; otherwise they are walls
  double half = 0;               ///< of the link's width [m]
  double gap = 0;                ///< from rim to rim, at least [m]
  double radius = 0;             ///< of the sharpest turn [m]
  Box room;                      ///< that the link's centre line keeps to
};

/// The way found from one of `from`'s rays to one of `to`'s, of lines and arcs without a corner,
/// that stays `gap` clear of every wall, rim to rim, and of itself. Only walls that stand nearer
/// than that to the point where it begins or ends are not counted, and only over the link's first
/// or last `own` length: a stroke's end lies within its own groove. Nearer than its width to a link
/// that it crosses it stands at 40 degrees or more to it, its first `own` length aside: a tip would
/// else take the wrong one of two grooves that run into each other.
/// A way is like a string drawn tight round circles at the ends, the corners and the bends of what
/// stands about: it turns at its ends with one, two or four `radius`, whichever fits, between them
/// only where something is in the way. The search takes the least length first, with turns the
/// dearer the sharper (A*, Hart, Nilsson and Raphael 1968; each circle once). Empty where none is
/// found; then there is no link. A pure function.
std::vector<Piece> FindLink(const LinkTask& task);

/// Least distance of a path from a wall, rim to rim, path points nearer than `skip_begin` to the
/// path's start and `skip_end` to its end along the way left out; sampled every `step` [m].
double LeastGap(const std::vector<Piece>& path, double half, const LinkWall& wall,
                double skip_begin, double skip_end, double step);

}  // namespace moontrace
