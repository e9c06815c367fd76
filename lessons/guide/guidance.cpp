#include "lessons/guide/guidance.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "lessons/guide/guidance_path.h"
#include "textures/base/finite.h"
#include "textures/base/units.h"

namespace moontrace {

namespace {

constexpr double kRampTime = 0.3;         ///< [s]
constexpr double kRest = 0.15;            ///< at a stroke's end, before the next [s]
constexpr double kLifted = 0.001;         ///< [m]
constexpr double kSlideSpeed = 0.1;       ///< of the target, added to a share of the tip's [m/s]
constexpr double kSlideShare = 2;         ///< of the tip's speed that a target may add
constexpr double kWindowWidths = 2;       ///< searched to either side
constexpr double kSeekWidths = 12;        ///< of a stroke, from its start, while it is sought
constexpr double kCaptureWidths = 1;      ///< the tip has come to a stroke
constexpr double kLostWidths = 3;         ///< beyond, amplify and corridor let a stroke go
constexpr double kCueFrequency = 100;     ///< ten ticks at 1 kHz [Hz]
constexpr double kDampingWidths = 0.125;  ///< beyond the dead zone, until damping is whole

double Smooth(double u) noexcept { return u * u * (3 - 2 * u); }

/// Limits a vector's length.
glm::dvec2 Held(glm::dvec2 force, double cap) noexcept {
  const double size = glm::length(force);
  return size > cap ? force * (cap / size) : force;
}

/// One tick: what all functions below need.
struct Tick {
  const GuidancePlan& plan;
  const GuidancePath& path;
  GuidanceState& state;
  glm::dvec2 p{0, 0};  ///< tip [m]
  glm::dvec2 v{0, 0};  ///< [m/s]
  bool lifted = false;
  double time = 0;   ///< of a tick [s]
  double slide = 0;  ///< how far a target may move in it [m]

  const GuidanceStroke& stroke() const noexcept { return path.strokes[state.stroke]; }
  double width() const noexcept { return stroke().width; }
  double leash() const noexcept { return plan.gains.leash_widths * width(); }
  /// Amplify and corridor lead nowhere.
  bool leads() const noexcept {
    return plan.mode != GuidanceMode::kAmplify && plan.mode != GuidanceMode::kCorridor;
  }
  bool has_bead() const noexcept { return plan.mode == GuidanceMode::kBead; }
};

double Slid(double from, double to, double most) noexcept {
  return from + std::clamp(to - from, -most, most);
}

glm::dvec2 TransitPoint(const Tick& t) noexcept {
  const glm::dvec2 to_start = PointAt(t.stroke(), 0) - t.state.from_P;
  const double length = glm::length(to_start);
  return length > 0 ? t.state.from_P + to_start * (t.state.bead / length) : t.state.from_P;
}

glm::dvec2 TargetOf(const Tick& t) noexcept {
  if (t.state.in_transit) return TransitPoint(t);
  if (!t.has_bead()) return PointAt(t.stroke(), t.state.s);
  return t.path.recorded() ? RecordedPointAt(t.path, t.state.time)
                           : PointAt(t.stroke(), t.state.bead);
}

/// The bead's step on a line or stroke that ends at `length`; the tip's foot on it is at `foot`.
void MoveBead(const Tick& t, glm::dvec2 bead_P, double foot, double length) noexcept {
  double& bead = t.state.bead;
  const double before = bead;
  if (glm::distance(t.p, bead_P) < t.leash() || foot > bead) {
    bead += t.plan.gains.bead_speed * t.time;
  }
  bead = std::max(bead, std::min(foot, before + t.slide));
  bead = std::min(bead, length);
}

void FollowTransit(const Tick& t) noexcept {
  GuidanceState& state = t.state;
  const glm::dvec2 to_start = PointAt(t.stroke(), 0) - state.from_P;
  const double length = glm::length(to_start);
  const double foot =
      length > 0 ? std::clamp(glm::dot(t.p - state.from_P, to_start) / length, 0.0, length) : 0;
  MoveBead(t, TransitPoint(t), foot, length);
  if (state.bead < length) return;
  state.in_transit = false;
  state.bead = state.s = 0;
}

/// Checks whether the tip has come to the stroke; until then the target slides back to its start.
void Seek(const Tick& t) noexcept {
  GuidanceState& state = t.state;
  const GuidanceStroke& stroke = t.stroke();
  const double reach = kCaptureWidths * stroke.width;
  double goal = 0;
  bool near = glm::distance(t.p, PointAt(stroke, 0)) <= reach;
  if (!near) {
    const NearestPlace place = NearestWithin(
        stroke, t.p, state.s, 0, std::min(stroke.length / 2, kSeekWidths * stroke.width));
    near = place.distance <= reach;
    if (near) goal = place.s;
  }
  state.s = Slid(state.s, goal, t.slide);
  state.captured = near && state.s == goal;
}

/// Of a mode that leads nowhere: this stroke or the next, wherever the tip comes to it.
void SeekAnywhere(const Tick& t) noexcept {
  GuidanceState& state = t.state;
  const std::size_t end = std::min(state.stroke + 2, t.path.strokes.size());
  double least = kCaptureWidths;
  for (std::size_t i = state.stroke; i < end; ++i) {
    const GuidanceStroke& stroke = t.path.strokes[i];
    const NearestPlace place =
        NearestWithin(stroke, t.p, 0, 0, std::min(stroke.length, 2 * kSeekWidths * stroke.width));
    if (!(place.distance < least * stroke.width)) continue;
    least = place.distance / stroke.width;
    state.stroke = i;
    state.s = place.s;
    state.captured = true;
    state.ramp = 0;
  }
}

void FollowStroke(const Tick& t) noexcept {
  GuidanceState& state = t.state;
  const GuidanceStroke& stroke = t.stroke();
  const double window = kWindowWidths * stroke.width;
  const NearestPlace place =
      NearestWithin(stroke, t.p, state.s, state.s - window, state.s + window);
  state.s = Slid(state.s, place.s, t.slide);
}

void Leave(const Tick& t) noexcept {
  GuidanceState& state = t.state;
  if (state.stroke + 1 >= t.path.strokes.size()) {
    state.done = true;
    return;
  }
  state.from_P = TargetOf(t);
  state.in_transit = t.leads();
  ++state.stroke;
  state.captured = state.at_end = false;
  state.s = state.bead = state.rest = 0;
}

bool IsAtEnd(const Tick& t) noexcept {
  const GuidanceStroke& stroke = t.stroke();
  const double off = glm::distance(t.p, PointAt(stroke, t.state.s));
  return t.state.s >= stroke.length - stroke.width / 2 && off <= kCaptureWidths * stroke.width;
}

/// Whether the stroke is done, and on to the next.
void Finish(const Tick& t) noexcept {
  GuidanceState& state = t.state;
  const bool at_end = IsAtEnd(t);
  if (t.has_bead()) {
    const bool there =
        t.path.recorded() ? state.time >= t.path.times.back() : state.bead >= t.stroke().length;
    if (there && glm::distance(t.p, TargetOf(t)) <= t.leash()) state.at_end = true;
  } else if (at_end) {
    state.at_end = true;
  }
  const bool broken_off = !t.has_bead() && t.lifted && state.s >= t.stroke().length / 2;
  state.rest = state.at_end || broken_off ? state.rest + t.time : 0;
  if (state.rest >= kRest || (state.at_end && at_end && t.lifted)) Leave(t);
}

void FollowBead(const Tick& t) noexcept {
  GuidanceState& state = t.state;
  if (!t.path.recorded()) {
    MoveBead(t, PointAt(t.stroke(), state.bead), state.captured ? state.s : 0, t.stroke().length);
  } else if (glm::distance(t.p, RecordedPointAt(t.path, state.time)) < t.leash()) {
    state.time = std::min(state.time + t.time, t.path.times.back());
  }
}

/// Where the push leads to after this tick, for the modes that lead.
void Lead(const Tick& t) noexcept {
  if (t.state.in_transit) {
    FollowTransit(t);
    return;
  }
  t.state.captured ? FollowStroke(t) : Seek(t);
  if (t.has_bead()) FollowBead(t);
  if (t.state.captured || t.has_bead()) Finish(t);
}

/// The same for the modes that do not; a stroke is let go only once its force has faded.
void Accompany(const Tick& t) noexcept {
  GuidanceState& state = t.state;
  if (!state.captured) {
    SeekAnywhere(t);
    return;
  }
  FollowStroke(t);
  if (IsAtEnd(t)) state.at_end = true;
}

bool IsParting(const Tick& t) noexcept {
  if (t.leads()) return false;
  return t.state.at_end ||
         glm::distance(t.p, PointAt(t.stroke(), t.state.s)) > kLostWidths * t.width();
}

/// Ramp-in, and the fading away where a stroke or all of them are over.
void Ramp(const Tick& t) noexcept {
  GuidanceState& state = t.state;
  const bool parting = state.captured && IsParting(t);
  const double step = t.time / kRampTime;
  state.ramp = std::clamp(state.ramp + (state.done || parting ? -step : step), 0.0, 1.0);
  if (!parting || state.done || state.ramp > 0) return;
  if (state.at_end) {
    Leave(t);
  } else {
    state.captured = false;
  }
}

/// Towards the target outside the dead zone, damped along the offset.
glm::dvec2 Attraction(const GuidanceGains& gains, double width, glm::dvec2 e,
                      glm::dvec2 v) noexcept {
  const double off = glm::length(e);
  const double beyond = off - gains.dead_zone_widths * width;
  if (!(beyond > 0)) return {0, 0};
  const glm::dvec2 out = e / off;
  const double damped = std::min(1.0, beyond / (kDampingWidths * width));
  return -out * (gains.stiffness * beyond + damped * gains.damping * glm::dot(v, out));
}

glm::dvec2 Amplification(const GuidanceGains& gains, const GuidanceStroke& stroke, glm::dvec2 p,
                         glm::dvec2 e) noexcept {
  const glm::dvec2 inside = glm::min(p - stroke.letter.min, stroke.letter.max - p);
  const double share = std::min(inside.x, inside.y) / (stroke.width / 2);
  const glm::dvec2 force = Held(gains.stiffness * e, gains.cap);
  return std::clamp(share, 0.0, 1.0) * force;
}

glm::dvec2 Cue(const GuidanceGains& gains, double width, glm::dvec2 e, double phase) noexcept {
  const double off = glm::length(e);
  const double beyond = off - gains.dead_zone_widths * width;
  if (!(beyond > 0)) return {0, 0};
  const double share = std::min(1.0, beyond / (width / 2));
  return e * (gains.cue_amplitude * share * std::sin(kTurn * phase) / off);
}

glm::dvec2 ForceOf(const Tick& t, glm::dvec2 e) noexcept {
  const GuidanceGains& gains = t.plan.gains;
  switch (t.plan.mode) {
    case GuidanceMode::kOff:
      break;
    case GuidanceMode::kAttract:
    case GuidanceMode::kRail:
    case GuidanceMode::kBead:
      return Attraction(gains, t.width(), e, t.v);
    case GuidanceMode::kAmplify:
      return t.state.captured ? Amplification(gains, t.stroke(), t.p, e) : glm::dvec2(0, 0);
    case GuidanceMode::kCorridor:
      return t.state.captured ? Cue(gains, t.width(), e, t.state.phase) : glm::dvec2(0, 0);
  }
  return {0, 0};
}

double SignedError(const Tick& t) noexcept {
  if (!t.state.captured) return 0;
  const glm::dvec2 off = t.p - PointAt(t.stroke(), t.state.s);
  const glm::dvec2 along = TangentAt(t.stroke(), t.state.s);
  return std::copysign(glm::length(off), along.x * off.y - along.y * off.x);
}

void Advance(const Tick& t) noexcept {
  GuidanceState& state = t.state;
  const double frequency = std::min(kCueFrequency, 0.25 / t.time);
  state.phase += frequency * t.time;
  state.phase -= std::floor(state.phase);
  if (!state.done) t.leads() ? Lead(t) : Accompany(t);
  Ramp(t);
  state.tip_P = t.p;
  state.begun = true;
}

}  // namespace

GuidanceResult Guide(const GuidancePlan& plan, GuidanceState& state, glm::dvec3 tip_P,
                     glm::dvec3 v_P, double tick) noexcept {
  GuidanceResult result;
  if (!IsFinite(tip_P) || !IsFinite(v_P) || !(tick > 0 && tick < 1)) {
    state.ramp = 0;
    state.begun = false;
    return result;
  }
  const glm::dvec2 p(tip_P);
  result.target_P = p;
  if (plan.mode == GuidanceMode::kOff || plan.path == nullptr || plan.path->strokes.empty() ||
      state.stroke >= plan.path->strokes.size()) {
    return result;
  }
  const double moved = state.begun ? glm::distance(p, state.tip_P) : 0;
  const Tick t{plan,
               *plan.path,
               state,
               p,
               glm::dvec2(v_P),
               tip_P.z > kLifted,
               tick,
               kSlideSpeed * tick + kSlideShare * moved};
  Advance(t);
  result.target_P = TargetOf(t);
  result.error = SignedError(t);
  const glm::dvec2 force =
      Smooth(state.ramp) * Held(ForceOf(t, p - result.target_P), plan.gains.cap);
  if (std::isfinite(force.x) && std::isfinite(force.y)) result.force_P = glm::dvec3(force, 0);
  return result;
}

}  // namespace moontrace
