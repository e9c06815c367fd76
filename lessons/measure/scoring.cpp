#include "lessons/measure/scoring.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <utility>

#include "lessons/measure/movement_meter.h"
#include "lessons/measure/stroke_trace.h"

namespace moontrace {
namespace {

constexpr std::size_t kMostLeftAt = 1000;  ///< places kept for pictures

}  // namespace

struct TraceScorer::State {
  std::vector<StrokeTrace> strokes;
  std::size_t glyph_count = 0;
  TraceTally air;  ///< time and forces between strokes
  std::vector<Excursion> left_at;
  std::size_t visits = 0;
  PauseMeter pauses;
  MovementMeter movement;
  std::size_t moving = 0;  ///< stroke of the movement

  bool any = false;  ///< the rest is of the sample before
  TraceSample last;
  bool last_counted = false;
  double last_error = 0, last_aside = 0;

  void AddForce(TraceTally& tally, const TraceSample& sample) const;
  void AddPause(TraceTally& tally, const TraceSample& sample);
  void AddLanding(StrokeTrace& stroke, const TraceSample& sample) const;
  void AddStroke(StrokeTrace& stroke, const TraceSample& sample);
  void AddExcursion(StrokeTrace& stroke, const TraceSample& sample, double error);
  void AddPath(StrokeTrace& stroke, const TraceSample& sample, double error, double aside) const;
  void AddDirection(StrokeTrace& stroke, glm::dvec2 p, glm::dvec2 tangent) const;
  void AddMovement(const TraceSample& sample);
  void EndMovement();
  /// Whether the sample before was of the same stroke and counted as well.
  bool GoesOn(const TraceSample& sample) const {
    return last_counted && last.stroke == sample.stroke;
  }
};

void TraceScorer::State::AddForce(TraceTally& tally, const TraceSample& sample) const {
  const double since = any ? sample.time - last.time : 0;
  tally.duration += since;
  if (sample.in_contact) tally.contact_time += since;
  const double force = glm::length(sample.force_P);
  if (!std::isfinite(force)) return;
  tally.peak_force = std::max(tally.peak_force, force);
  if (!sample.in_contact) return;
  const double normal = std::abs(sample.force_P.z);
  tally.force_sum += force;
  tally.normal_sum += normal;
  tally.peak_normal = std::max(tally.peak_normal, normal);
  ++tally.contacts;
}

void TraceScorer::State::AddPause(TraceTally& tally, const TraceSample& sample) {
  if (!sample.in_contact) {
    pauses.Break();
    return;
  }
  const PauseMeter::Step step = pauses.Add(sample.time, glm::dvec2(sample.tip_P));
  tally.pause_time += step.time;
  if (step.began) ++tally.pauses;
}

void TraceScorer::State::AddLanding(StrokeTrace& stroke, const TraceSample& sample) const {
  const bool same = any && last.phase == sample.phase && last.stroke == sample.stroke;
  // reached over the page: it goes on without landing
  if (any && last.phase == TracePhase::kTravel && last.in_contact) stroke.landed = true;
  if (sample.phase == TracePhase::kEntry && !same) stroke.landed = false;
  if (!sample.in_contact || sample.phase == TracePhase::kLift) return;
  if (!stroke.landed) {
    stroke.landed = true;
    ++stroke.tally.entries;
    const double aside = glm::length(glm::dvec2(sample.tip_P) - stroke.spine.start());
    stroke.tally.entry_error = std::max(stroke.tally.entry_error, aside);
  } else if (sample.phase == TracePhase::kStroke && same && !last.in_contact) {
    ++stroke.tally.lifts;
  }
}

void TraceScorer::State::AddStroke(StrokeTrace& stroke, const TraceSample& sample) {
  const glm::dvec2 p(sample.tip_P);
  const double error = stroke.Cover(p);
  if (stroke.is_dot) {
    stroke.closest = std::min(stroke.closest, error);
  } else {
    const Spine::Foot foot = stroke.spine.FootOf(p);
    AddExcursion(stroke, sample, error);
    // across a fill's floor nothing is aside
    const double aside =
        stroke.outline_P.empty() ? foot.aside : std::clamp(foot.aside, -error, error);
    AddPath(stroke, sample, error, aside);
    AddDirection(stroke, p, foot.tangent);
    AddMovement(sample);
    stroke.path.Add(p);
    last_error = error;
    last_aside = aside;
  }
  if (stroke.visit == 0 && stroke.visited()) stroke.visit = ++visits;
}

void TraceScorer::State::AddExcursion(StrokeTrace& stroke, const TraceSample& sample,
                                      double error) {
  TraceTally& tally = stroke.tally;
  tally.max_error = std::max(tally.max_error, error);
  if (stroke.out && GoesOn(sample)) tally.time_outside += sample.time - last.time;
  if (!stroke.out && error > stroke.width / 2) {
    stroke.out = true;
    ++tally.excursions;
    if (left_at.size() < kMostLeftAt) {
      left_at.push_back({glm::dvec2(sample.tip_P), sample.time, sample.stroke});
    }
  } else if (stroke.out && error <= stroke.width / 4) {
    stroke.out = false;
  }
}

void TraceScorer::State::AddPath(StrokeTrace& stroke, const TraceSample& sample, double error,
                                 double aside) const {
  if (!GoesOn(sample)) return;
  // Exact for an error that changes evenly between the two samples.
  TraceTally& tally = stroke.tally;
  const double step = glm::length(glm::dvec2(sample.tip_P) - glm::dvec2(last.tip_P));
  tally.path_length += step;
  tally.error_integral += step * (last_error + error) / 2;
  tally.square_error_integral +=
      step * (last_error * last_error + last_error * error + error * error) / 3;
  tally.offset_integral += step * (last_aside + aside) / 2;
  tally.followed += step;
  tally.follow_time += sample.time - last.time;
}

/// In steps of w/4, so that tremor does not count as going to and fro.
void TraceScorer::State::AddDirection(StrokeTrace& stroke, glm::dvec2 p, glm::dvec2 tangent) const {
  if (!last_counted || &stroke != &strokes[last.stroke]) stroke.mark = p;
  const glm::dvec2 step = p - stroke.mark;
  if (glm::length(step) < stroke.width / 4) return;
  const double along = glm::dot(step, tangent);
  (along > 0 ? stroke.tally.forward : stroke.tally.backward) += std::abs(along);
  stroke.mark = p;
}

void TraceScorer::State::AddMovement(const TraceSample& sample) {
  if (!GoesOn(sample) || !movement.Takes(sample.time)) EndMovement();
  moving = sample.stroke;
  movement.Add(sample.time, glm::dvec2(sample.tip_P));
}

void TraceScorer::State::EndMovement() {
  const double time = movement.duration();
  if (time > 0) Include(strokes[moving].tally, movement.Measure(), time);
  movement.Clear();
}

TraceScorer::TraceScorer(const std::vector<IntendedStroke>& strokes, std::size_t glyph_count)
    : state_(std::make_unique<State>()) {
  state_->glyph_count = glyph_count;
  state_->left_at.reserve(kMostLeftAt);
  state_->strokes.reserve(strokes.size());
  for (const IntendedStroke& stroke : strokes) {
    if (stroke.glyph >= glyph_count) {
      throw std::invalid_argument("scoring: a stroke names a glyph that the page does not have");
    }
    state_->strokes.emplace_back(stroke);
  }
}

TraceScorer::~TraceScorer() = default;
TraceScorer::TraceScorer(TraceScorer&&) noexcept = default;
TraceScorer& TraceScorer::operator=(TraceScorer&&) noexcept = default;

void TraceScorer::Add(TraceSample sample) {
  State& state = *state_;
  const glm::dvec3 p = sample.tip_P;
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) sample.in_contact = false;
  const bool apart = sample.phase == TracePhase::kAir || sample.phase == TracePhase::kTravel;
  StrokeTrace* stroke = apart ? nullptr : &state.strokes.at(sample.stroke);
  TraceTally& tally = apart ? state.air : stroke->tally;
  state.AddForce(tally, sample);
  state.AddPause(tally, sample);
  if (!apart) state.AddLanding(*stroke, sample);
  const bool counted = sample.phase == TracePhase::kStroke && sample.in_contact;
  if (counted) {
    state.AddStroke(*stroke, sample);
  } else {
    state.EndMovement();
  }
  state.last_counted = counted;
  state.last = sample;
  state.any = true;
}

double TraceScorer::Coverage() const {
  TraceTally all;
  for (const StrokeTrace& stroke : state_->strokes) {
    const TraceTally closed = stroke.Closed();
    all.length += closed.length;
    all.covered += closed.covered;
  }
  return MetricsOf(all).coverage;
}

namespace {

/// Pairs of one letter's strokes, visited one before the other.
void AddOrder(std::vector<TraceTally>& letters, const std::vector<StrokeTrace>& strokes) {
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    // A letter's strokes stand side by side.
    for (std::size_t j = i; j-- > 0 && strokes[j].glyph == strokes[i].glyph;) {
      if (strokes[i].visit == 0 || strokes[j].visit == 0) continue;
      TraceTally& letter = letters[strokes[i].glyph];
      ++(strokes[j].visit < strokes[i].visit ? letter.in_order : letter.out_of_order);
    }
  }
}

}  // namespace

TraceScore TraceScorer::Finish() const {
  std::vector<TraceTally> letters(state_->glyph_count);
  for (const StrokeTrace& stroke : state_->strokes) {
    TraceTally closed = stroke.Closed();
    stroke.AddShape(closed);
    Include(letters[stroke.glyph], closed);
  }
  AddOrder(letters, state_->strokes);
  const double moving = state_->movement.duration();
  if (moving > 0) {
    Include(letters[state_->strokes[state_->moving].glyph], state_->movement.Measure(), moving);
  }
  TraceScore score;
  TraceTally total = state_->air;
  double traced = 0;
  for (const TraceTally& letter : letters) {
    score.letters.push_back(MetricsOf(letter));
    if (letter.length > 0 && score.letters.back().coverage >= 0.5) ++traced;
    Include(total, letter);
  }
  score.total = MetricsOf(total);
  if (total.duration > 0) score.letters_per_second = traced / total.duration;
  score.left_at = state_->left_at;
  return score;
}

}  // namespace moontrace
