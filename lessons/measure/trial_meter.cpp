#include "lessons/measure/trial_meter.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace moontrace {
namespace {

/// Groove width of a page's strokes, weighed by their length [m].
double MeanWidth(const std::vector<IntendedStroke>& strokes) {
  double length = 0, sum = 0;
  for (const IntendedStroke& stroke : strokes) {
    double own = stroke.width;  // so that dots count too
    for (const Piece& piece : stroke.spine_P) own += Length(piece);
    length += own;
    sum += own * stroke.width;
  }
  return length > 0 ? sum / length : 0;
}

}  // namespace

struct TrialMeter::State {
  TraceScorer scorer;
  double tick = 0, width = 0;  ///< [s], [m]
  bool touched = false;
  double first_touch = 0, last_touch = 0;  ///< [s]

  bool any = false;  ///< the rest is of the sample before
  glm::dvec3 tip_P{0, 0, 0}, guidance_P{0, 0, 0};
  double guided_time = 0;  ///< time in which a push was on [s]
  double impulse = 0;      ///< integral of the push's magnitude [N s]
  double work = 0;         ///< [J]
};

TrialMeter::TrialMeter(const std::vector<IntendedStroke>& strokes, std::size_t glyph_count,
                       double tick)
    : state_(std::make_unique<State>(State{TraceScorer(strokes, glyph_count)})) {
  state_->tick = tick;
  state_->width = MeanWidth(strokes);
}

TrialMeter::~TrialMeter() = default;
TrialMeter::TrialMeter(TrialMeter&&) noexcept = default;
TrialMeter& TrialMeter::operator=(TrialMeter&&) noexcept = default;

void TrialMeter::Add(const TraceSample& sample, glm::dvec3 guidance_P) {
  State& state = *state_;
  state.scorer.Add(sample);
  if (sample.in_contact) {
    if (!state.touched) state.first_touch = sample.time;
    state.touched = true;
    state.last_touch = sample.time;
  }
  const double push = glm::length(guidance_P);
  const glm::dvec3 step = sample.tip_P - state.tip_P;
  if (!std::isfinite(push) || !std::isfinite(glm::dot(sample.tip_P, sample.tip_P))) return;
  if (push > 0) {
    state.guided_time += state.tick;
    state.impulse += push * state.tick;
  }
  if (state.any) state.work += glm::dot((state.guidance_P + guidance_P) / 2.0, step);
  state.any = true;
  state.tip_P = sample.tip_P;
  state.guidance_P = guidance_P;
}

void TrialMeter::Fill(Trial& trial) const {
  const State& state = *state_;
  const TraceMetrics total = state.scorer.Finish().total;
  trial.coverage = total.coverage;
  trial.mean_error = total.mean_error;
  trial.rms_error = total.rms_error;
  trial.error_widths = state.width > 0 ? total.mean_error / state.width : 0;
  trial.wander_offs = static_cast<std::int64_t>(total.excursions);
  trial.duration = state.touched ? state.last_touch - state.first_touch : 0;
  trial.log_jerk = total.smoothness.log_jerk;
  trial.spectral_arc = total.smoothness.spectral_arc;
  trial.mean_force = total.mean_force;
  trial.mean_guidance = state.guided_time > 0 ? state.impulse / state.guided_time : 0;
  trial.guidance_work = state.work;
}

double TrialMeter::Coverage() const { return state_->scorer.Coverage(); }

}  // namespace moontrace
