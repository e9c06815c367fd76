#include "sim/trial/plan.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "sim/trial/speed_profile.h"
#include "textures/base/overload.h"
#include "textures/field/fill.h"

namespace moontrace {
namespace {

constexpr double kStep = 0.005;         // between points of a moving aim [s]
constexpr double kShortestRise = 0.15;  // up or down [s]
constexpr double kShortestHop = 0.25;   // across, so that the hand does not ring on landing [s]
constexpr double kPressRamp = 0.05;     // in which press comes and goes [s]
constexpr double kEndRest = 0.05;       // at a stroke's end, in which a lagging hand arrives [s]
constexpr double kEaseRest = 0.15;      // with an eased press, in which drift fades [s]
constexpr double kEasePress = 0.68;     // [N]
constexpr double kTick = 1e-3;          // [s]
constexpr double kEaseDepth = 3.4e-3;   // aimed at below a groove's floor then: 0.68 N [m]
constexpr double kFirstRest = 0.1;      // above the first stroke [s]
constexpr double kCornerCosine = 0.9396926207859084;  // of 20 degrees

// After a corner the aim leans outwards by this share of the stroke so far (as much as a hand
// may have drifted), within this time; then over these lengths, in groove widths at a right angle,
// it holds and returns: by then the grooves of the two legs have parted.
constexpr double kLeanShare = 0.06;
constexpr double kLeanTime = 0.1;  // [s]
constexpr double kLeanWidths = 0.5;

// Where a link leaves a ring, two grooves part at a narrow angle. The aim leans into the ring while
// that is traced and away from it where it is left, by as much as a hand drifts at most (the hand's
// share times wavelength over pi is 1.9 mm), until the grooves have parted.
constexpr double kRingLean = 2e-3;      // [m], and at most
constexpr double kRingLeanShare = 0.4;  // of the groove's width: more would leave its middle
constexpr double kRingLeanWidths = 3;   // held, and then returned over as much
constexpr double kReturnWidths = 0.75;

// A ring that borders on a fill has no inner wall there, which would hold a hand that has drifted:
// the aim leans against the outer one. Told apart at places this far from each other.
constexpr double kFillStep = 0.25;  // [w]

/// Whether travel goes on from `a` to `b` without a corner.
bool IsSmooth(const Piece& a, const Piece& b) {
  return glm::dot(TangentAt(a, Length(a)), TangentAt(b, 0)) > kCornerCosine;
}

/// The first `length` [m] of a piece.
Piece FrontOf(const Piece& piece, double length) {
  const double share = std::min(1.0, length / Length(piece));
  const auto of_line = [length](const Line& line) {
    return Line{line.from, PointAt(line, length)};
  };
  const auto of_arc = [share](const Arc& arc) {
    return Arc{arc.center, arc.radius, arc.start, share * arc.sweep};
  };
  return std::visit<Piece>(Overload{of_line, of_arc}, piece);
}

/// A path cut at its corners; a smooth closed one goes `beyond` its start.
std::vector<std::vector<Piece>> RunsOf(const std::vector<Piece>& path, double width,
                                       double beyond) {
  std::vector<Piece> pieces;
  for (const Piece& piece : path) {
    if (Length(piece) > 0) pieces.push_back(piece);
  }
  if (pieces.empty()) return {};
  const bool closed = glm::length(EndOf(pieces.back()) - StartOf(pieces.front())) < 1e-3 * width;
  if (beyond > 0 && closed && IsSmooth(pieces.back(), pieces.front())) {
    pieces.push_back(FrontOf(pieces.front(), beyond));
  }
  std::vector<std::vector<Piece>> runs;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i == 0 || !IsSmooth(pieces[i - 1], pieces[i])) runs.emplace_back();
    runs.back().push_back(pieces[i]);
  }
  return runs;
}

/// Point at an arc length of a run.
glm::dvec2 PointOf(const std::vector<Piece>& run, double s) {
  for (std::size_t i = 0; i + 1 < run.size(); ++i) {
    const double length = Length(run[i]);
    if (s <= length) return PointAt(run[i], s);
    s -= length;
  }
  return PointAt(run.back(), s);
}

/// Sideways offset of the aim along a run.
struct Lean {
  glm::dvec2 offset_P{0, 0};  ///< at the run's start [m]
  double hold = 0;            ///< length over which it stays [m]
  double back = 0;            ///< length over which it then dies away [m]

  glm::dvec2 At(double s) const {
    const double u = back > 0 ? std::clamp((s - hold) / back, 0.0, 1.0) : 1;
    return (1 - u * u * (3 - 2 * u)) * offset_P;
  }
  /// Greatest growth of the path's length by leaning: the smooth step's slope is at most 3/2.
  double Stretch() const {
    return back > 0 ? std::hypot(1.0, 1.5 * glm::length(offset_P) / back) : 1;
  }
};

/// Away from the leg that it came by.
Lean LeanAfter(const std::vector<Piece>& before, const std::vector<Piece>& run, double travelled,
               double width) {
  const glm::dvec2 came = TangentAt(before.back(), Length(before.back()));
  const glm::dvec2 goes = TangentAt(run.front(), 0);
  const glm::dvec2 outwards = came - glm::dot(came, goes) * goes;
  const double across = glm::length(outwards);
  if (across < 1e-6) return {};
  const double length = Length(run);
  // Legs at a smaller angle part later.
  const double scale = std::min(width / across, length / (kLeanWidths + kReturnWidths));
  return {kLeanShare * travelled / across * outwards, kLeanWidths * scale, kReturnWidths * scale};
}

/// Writes a plan from its beginning to its end.
class PlanWriter {
 public:
  PlanWriter(const PlanOptions& options, const Pose& X_WP, glm::dvec3 begin_P)
      : options_(options), X_WP_(X_WP), p_P_(begin_P) {
    plan_.path_W.press_direction_D = TurnToWorld(X_WP, {0, 0, -1});
    AddPoint();
  }

  /// The present phase ends now.
  void EndSpan(TracePhase phase, std::size_t stroke) {
    const double begin = plan_.spans.empty() ? 0 : plan_.spans.back().end;
    if (time_ > begin) plan_.spans.push_back({begin, time_, phase, stroke});
  }

  void Rest(double duration) {
    if (!(duration > 0)) return;
    time_ += duration;
    AddPoint();
  }

  void Press(double press) {
    press_ = press;
    Rest(kPressRamp);
  }

  /// Eases the press for a moment without leaving the groove, which takes the hand to its middle.
  void Ease(double width, double press) {
    const double height = p_P_.z;
    p_P_.z = -width / 2 - kEaseDepth;
    press_ = 0;
    Rest(kTick);  // at once: under a lighter press a hand that has drifted would leave the groove
    Rest(kEaseRest);
    p_P_.z = height;
    press_ = kEasePress;  // as much as the height held has pressed
    Rest(kTick);
    Press(press);
  }

  /// Straight, with the least jerk (Flash and Hogan 1985), whose peak speed is 15/8 of the mean.
  void GoTo(glm::dvec3 to_P, double shortest) {
    const glm::dvec3 from_P = p_P_, travel_P = to_P - from_P;
    const double duration = std::max(shortest, 1.875 * glm::length(travel_P) / options_.air_speed);
    const double begin = time_;
    const int count = static_cast<int>(std::ceil(duration / kStep));
    for (int i = 1; i <= count; ++i) {
      const double u = static_cast<double>(i) / count;
      time_ = begin + duration * u;
      p_P_ = i == count ? to_P : from_P + u * u * u * (10 + u * (6 * u - 15)) * travel_P;
      AddPoint();
    }
  }

  void Follow(const std::vector<Piece>& run, const Lean& lean) {
    if (lean.offset_P != glm::dvec2(0, 0)) GoTo(p_P_ + glm::dvec3(lean.offset_P, 0), kLeanTime);
    const std::vector<double> arc_lengths = TimeRun(run, options_.speed / lean.Stretch(), kStep);
    const double begin = time_;
    for (std::size_t i = 1; i < arc_lengths.size(); ++i) {
      time_ = begin + kStep * static_cast<double>(i);
      p_P_ = {PointOf(run, arc_lengths[i]) + lean.At(arc_lengths[i]), 0};
      AddPoint();
    }
  }

  glm::dvec3 p_P() const { return p_P_; }

  Plan Finish() {
    plan_.duration = time_;
    return std::move(plan_);
  }

 private:
  void AddPoint() { plan_.path_W.points.push_back({time_, ToWorld(X_WP_, p_P_), press_}); }

  PlanOptions options_;
  Pose X_WP_;
  Plan plan_;
  double time_ = 0;
  glm::dvec3 p_P_{0, 0, 0};
  double press_ = 0;
};

double PressOn(const IntendedStroke& stroke, const PlanOptions& options) {
  return stroke.relief == Relief::kEmbossed ? options.ridge_press.value_or(options.press)
                                            : options.press;
}

void Land(PlanWriter& writer, const IntendedStroke& to, std::size_t stroke,
          const PlanOptions& options) {
  const glm::dvec2 start = StartOf(to.spine_P.front());
  const glm::dvec3 above(start, options.clearance);
  if (writer.p_P() != above) writer.GoTo(above, kShortestHop);
  writer.EndSpan(TracePhase::kAir, stroke);
  writer.GoTo({start, 0}, kShortestRise);
  writer.Press(PressOn(to, options));
  writer.Rest(options.settle);
  writer.EndSpan(TracePhase::kEntry, stroke);
}

void FollowRuns(PlanWriter& writer, const std::vector<std::vector<Piece>>& runs, double width) {
  double travelled = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    writer.Follow(runs[i], i > 0 ? LeanAfter(runs[i - 1], runs[i], travelled, width) : Lean{});
    for (const Piece& piece : runs[i]) travelled += Length(piece);
  }
}

/// The arc of a ring traced by itself, none for other strokes.
std::optional<Arc> RingOf(const std::vector<Piece>& trace) {
  if (trace.empty()) return std::nullopt;
  const bool closed = glm::distance(StartOf(trace.front()), EndOf(trace.back())) < 1e-6;
  return closed && IsSmooth(trace.back(), trace.front()) ? ArcOf(trace.front()) : std::nullopt;
}

double LeanOf(const Arc& ring, double width) {
  return std::min({kRingLean, kRingLeanShare * width, ring.radius / 2});
}

/// A part of a ring, nearer to its middle by a share of the lean, or farther if that is below zero.
std::vector<Piece> Inwards(std::vector<Piece> part, double width, double share) {
  for (Piece& piece : part) {
    std::visit(Overload{[](Line&) {}, [=](Arc& arc) { arc.radius -= share * LeanOf(arc, width); }},
               piece);
  }
  return part;
}

void FollowInwards(PlanWriter& writer, const std::vector<Piece>& part, double width,
                   double share = 1) {
  const std::vector<Piece> inner = Inwards(part, width, share);
  if (inner.empty()) return;
  writer.GoTo({StartOf(inner.front()), 0}, kLeanTime);
  FollowRuns(writer, RunsOf(inner, width, 0), width);
}

/// Part `i`, from 0, of `count` equally long ones.
Piece EqualPart(const Piece& piece, double i, double count) {
  const auto of_line = [=, length = Length(piece)](const Line& line) {
    return Line{PointAt(line, length * i / count), PointAt(line, length * (i + 1) / count)};
  };
  const auto of_arc = [=](const Arc& arc) {
    const double sweep = arc.sweep / count;
    return Arc{arc.center, arc.radius, arc.start + i * sweep, sweep};
  };
  return std::visit<Piece>(Overload{of_line, of_arc}, piece);
}

/// Pieces cut so that none is longer than `most`.
std::vector<Piece> CutShort(const std::vector<Piece>& path, double most) {
  std::vector<Piece> parts;
  for (const Piece& piece : path) {
    const double count = std::ceil(Length(piece) / most);
    for (double i = 0; i < count; ++i) parts.push_back(EqualPart(piece, i, count));
  }
  return parts;
}

using Outlines = std::vector<std::vector<Piece>>;

/// Of the fills of a stroke's letter.
Outlines FillsBeside(const std::vector<IntendedStroke>& strokes, std::size_t stroke) {
  Outlines fills;
  for (const IntendedStroke& other : strokes) {
    if (other.glyph != strokes[stroke].glyph || other.outline_P.empty()) continue;
    fills.push_back(other.outline_P);
  }
  return fills;
}

/// Whether a fill takes away a ring's inner wall beside a point of it.
bool IsOpenInside(const Arc& ring, glm::dvec2 p, double width, const Outlines& fills) {
  const glm::dvec2 inner_edge = p + width / 2 * glm::normalize(ring.center - p);
  return std::any_of(fills.begin(), fills.end(), [&](const std::vector<Piece>& outline) {
    return IsInside(outline, inner_edge);
  });
}

/// A part of a ring, and whether it has no inner wall.
struct RingPart {
  std::vector<Piece> pieces;
  bool is_open = false;
};

std::vector<RingPart> PartsBesideFills(const std::vector<Piece>& path, double width,
                                       const Outlines& fills) {
  std::vector<RingPart> parts;
  for (const Piece& piece : fills.empty() ? path : CutShort(path, kFillStep * width)) {
    const std::optional<Arc> arc = ArcOf(piece);
    const bool is_open = arc && IsOpenInside(*arc, PointAt(piece, Length(piece) / 2), width, fills);
    if (parts.empty() || parts.back().is_open != is_open) parts.push_back({{}, is_open});
    parts.back().pieces.push_back(piece);
  }
  return parts;
}

/// A ring or a part of it, leaning inwards by a share, and outwards where a fill opens it.
void FollowRing(PlanWriter& writer, const std::vector<Piece>& run, double width,
                const Outlines& fills, double share) {
  for (const RingPart& part : PartsBesideFills(run, width, fills)) {
    FollowInwards(writer, part.pieces, width, part.is_open ? -1 : share);
  }
}

/// Once round, in quarters between which the hand finds the groove's middle again.
void TraceRing(PlanWriter& writer, const WalkStep& step, const IntendedStroke& stroke,
               const Outlines& fills, const PlanOptions& options) {
  const double length = Length(step.trace_P);
  bool first = true;
  for (const Piece& part : CutShort(step.trace_P, length / 4 * (1 + 1e-9))) {
    if (!first && stroke.relief == Relief::kEngraved) {
      writer.EndSpan(TracePhase::kStroke, step.stroke);
      writer.Ease(stroke.width, PressOn(stroke, options));
      writer.EndSpan(TracePhase::kTravel, step.stroke);
    }
    FollowRing(writer, {part}, stroke.width, fills, 1);
    writer.Rest(kEndRest);
    first = false;
  }
}

/// The ring of a stroke's letter, if it has one.
std::optional<Arc> RingBeside(const std::vector<IntendedStroke>& strokes, std::size_t stroke) {
  for (const IntendedStroke& other : strokes) {
    const std::optional<Arc> ring =
        other.glyph == strokes[stroke].glyph ? RingOf(other.spine_P) : std::nullopt;
    if (ring) return ring;
  }
  return std::nullopt;
}

/// Leaves a letter that has a ring: to that if it is not there, along it as far as needed, then
/// away from it.
void LeaveRing(PlanWriter& writer, const Arc& ring, const std::vector<Piece>& path, double width,
               const Outlines& fills) {
  const auto in_ring = [&ring](const Piece& piece) {
    const std::optional<Arc> arc = ArcOf(piece);
    return arc && glm::distance(arc->center, ring.center) < 1e-9 &&
           std::abs(arc->radius - ring.radius) < 1e-9;
  };
  const auto on_it = std::find_if(path.begin(), path.end(), in_ring);
  const auto begin = on_it == path.end() ? path.begin() : on_it;
  const auto away = std::find_if_not(begin, path.end(), in_ring);
  FollowRuns(writer, RunsOf({path.begin(), begin}, width, 0), width);
  FollowRing(writer, {begin, away}, width, fills, 1);
  const auto runs = RunsOf({away, path.end()}, width, 0);
  if (runs.empty()) return;
  const glm::dvec2 start = StartOf(runs.front().front());
  const double hold = kRingLeanWidths * width;
  const Lean lean{LeanOf(ring, 10 * width) * glm::normalize(start - ring.center), hold, hold};
  writer.GoTo({start, 0}, kLeanTime);
  writer.Follow(runs.front(), lean);
  FollowRuns(writer, {runs.begin() + 1, runs.end()}, width);
}

void WriteWalk(PlanWriter& writer, const Walk& walk, const std::vector<IntendedStroke>& strokes,
               const PlanOptions& options) {
  bool on_ring = false;  // it was traced last
  for (const WalkStep& step : walk) {
    const IntendedStroke& stroke = strokes[step.stroke];
    if (&step == &walk.front()) {
      Land(writer, stroke, step.stroke, options);
    } else {
      const std::size_t last = (&step - 1)->stroke;
      const std::optional<Arc> ring = RingBeside(strokes, last);
      // a link begins shallower than the stroke: a hand that has drifted would slide back in that
      if (!on_ring && stroke.relief == Relief::kEngraved) {
        writer.Ease(stroke.width, PressOn(stroke, options));
      }
      if (ring) {
        LeaveRing(writer, *ring, step.path_P, stroke.width, FillsBeside(strokes, last));
      } else {
        FollowRuns(writer, RunsOf(step.path_P, stroke.width, 0), stroke.width);
      }
      writer.Rest(kEndRest);
      if (stroke.relief == Relief::kEngraved) writer.Ease(stroke.width, PressOn(stroke, options));
      writer.EndSpan(TracePhase::kTravel, step.stroke);
    }
    const bool is_ring = RingOf(step.trace_P).has_value();
    on_ring = is_ring && walk.size() > 1;
    const auto runs = RunsOf(step.trace_P, stroke.width, stroke.width / 4);
    const Outlines fills = is_ring ? FillsBeside(strokes, step.stroke) : Outlines();
    if (on_ring) {
      TraceRing(writer, step, stroke, fills, options);
    } else if (!fills.empty()) {
      FollowRing(writer, runs.front(), stroke.width, fills, 0);
    } else {
      FollowRuns(writer, runs, stroke.width);
    }
    writer.Rest(runs.empty() ? options.dot_rest : kEndRest);
    writer.EndSpan(TracePhase::kStroke, step.stroke);
  }
  writer.Press(0);
  writer.GoTo({glm::dvec2(writer.p_P()), options.clearance}, kShortestRise);
  writer.EndSpan(TracePhase::kLift, walk.back().stroke);
}

}  // namespace

Plan MakePlan(const std::vector<IntendedStroke>& strokes, const std::vector<Walk>& walks,
              const PlanOptions& options, const Pose& X_WP) {
  glm::dvec2 start{0, 0};
  if (!walks.empty()) start = StartOf(strokes[walks.front().front().stroke].spine_P.front());
  PlanWriter writer(options, X_WP, {start, options.clearance});
  writer.Rest(kFirstRest);
  for (const Walk& walk : walks) WriteWalk(writer, walk, strokes, options);
  if (options.repeats) writer.GoTo({start, options.clearance}, kShortestHop);
  writer.EndSpan(TracePhase::kAir, 0);
  Plan plan = writer.Finish();
  plan.path_W.repeats = options.repeats;
  return plan;
}

Plan MakeOraclePlan(const std::vector<IntendedStroke>& strokes, const PlanOptions& options,
                    const Pose& X_WP) {
  return MakePlan(strokes, SeparateWalks(strokes), options, X_WP);
}

}  // namespace moontrace
