#include "lessons/scoring.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "lessons/spine.h"

namespace moontrace {
namespace {

constexpr std::size_t kCapacity = 16;      ///< covered parts of a stroke held without allocating
constexpr std::size_t kMostLeftAt = 1000;  ///< places kept for pictures

/// What has been summed for one stroke, one letter or all: plain sums, so that they add.
struct Tally {
  double length = 0, covered = 0;  ///< intended [m]
  double way = 0;                  ///< of the tip, weight of the errors [m]
  double error_way = 0;            ///< integral of the error over the way [m^2]
  double square_way = 0;           ///< of its square [m^3]
  double max_error = 0;
  std::size_t excursions = 0, entries = 0, lifts = 0;
  double entry_error = 0;
  double duration = 0;
  double force_sum = 0, peak_force = 0;
  std::size_t contacts = 0;  ///< samples in contact
};

void Include(Tally& sum, const Tally& part) {
  sum.length += part.length;
  sum.covered += part.covered;
  sum.way += part.way;
  sum.error_way += part.error_way;
  sum.square_way += part.square_way;
  sum.max_error = std::max(sum.max_error, part.max_error);
  sum.excursions += part.excursions;
  sum.entries += part.entries;
  sum.lifts += part.lifts;
  sum.entry_error = std::max(sum.entry_error, part.entry_error);
  sum.duration += part.duration;
  sum.force_sum += part.force_sum;
  sum.peak_force = std::max(sum.peak_force, part.peak_force);
  sum.contacts += part.contacts;
}

TraceMetrics MetricsOf(const Tally& tally) {
  TraceMetrics metrics;
  metrics.coverage = tally.length > 0 ? std::min(1.0, tally.covered / tally.length) : 0;
  // Touched without a way: a tip that rested in one place.
  const bool moved = tally.way > 0;
  metrics.mean_error = moved ? tally.error_way / tally.way : tally.max_error;
  metrics.rms_error = moved ? std::sqrt(tally.square_way / tally.way) : tally.max_error;
  metrics.max_error = tally.max_error;
  metrics.excursions = tally.excursions;
  metrics.duration = tally.duration;
  metrics.mean_force =
      tally.contacts > 0 ? tally.force_sum / static_cast<double>(tally.contacts) : 0;
  metrics.peak_force = tally.peak_force;
  metrics.entries = tally.entries;
  metrics.lifts = tally.lifts;
  metrics.entry_error = tally.entry_error;
  return metrics;
}

/// One intended stroke and what has become of it.
struct Progress {
  explicit Progress(const IntendedStroke& stroke)
      : spine(stroke.spine_P),
        covered(kCapacity),
        width(stroke.width),
        glyph(stroke.glyph),
        is_dot(stroke.kind == StrokeKind::kDot || !(spine.length() > 0)) {}

  /// The sums with coverage, and a dot's closest approach, put in.
  Tally Closed() const {
    Tally closed = tally;
    closed.length = is_dot ? width : spine.length();
    closed.covered = covered.Total();
    if (is_dot) closed.covered = closest <= width / 4 ? width : 0;
    if (is_dot && std::isfinite(closest)) {
      closed.way = width;
      closed.error_way = width * closest;
      closed.square_way = width * closest * closest;
      closed.max_error = closest;
    }
    return closed;
  }

  Spine spine;
  CoveredLength covered;
  double width = 0;
  std::size_t glyph = 0;
  bool is_dot = false;
  bool landed = false;  ///< since the hand last came down on it
  bool out = false;     ///< beyond w/2 and not yet back within w/4
  double closest = std::numeric_limits<double>::infinity();  ///< of a dot [m]
  Tally tally;
};

}  // namespace

struct TraceScorer::State {
  std::vector<Progress> strokes;
  std::size_t glyph_count = 0;
  Tally air;  ///< time and forces between strokes
  std::vector<Excursion> left_at;

  bool any = false;  ///< the rest tells of the sample before
  TraceSample last;
  bool last_counted = false;
  double last_error = 0;

  void AddForce(Tally& tally, const TraceSample& sample) const;
  void AddLanding(Progress& stroke, const TraceSample& sample) const;
  double AddError(Progress& stroke, const TraceSample& sample);
};

void TraceScorer::State::AddForce(Tally& tally, const TraceSample& sample) const {
  if (any) tally.duration += sample.time - last.time;
  const double force = glm::length(sample.force_P);
  if (!sample.in_contact || !std::isfinite(force)) return;
  tally.force_sum += force;
  tally.peak_force = std::max(tally.peak_force, force);
  ++tally.contacts;
}

void TraceScorer::State::AddLanding(Progress& stroke, const TraceSample& sample) const {
  const bool same = any && last.phase == sample.phase && last.stroke == sample.stroke;
  // reached over the page: it goes on without landing
  if (any && last.phase == TracePhase::kWay && last.in_contact) stroke.landed = true;
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

double TraceScorer::State::AddError(Progress& stroke, const TraceSample& sample) {
  const glm::dvec2 p(sample.tip_P);
  const double error = stroke.spine.Cover(p, stroke.width / 4, stroke.covered);
  if (stroke.is_dot) {
    stroke.closest = std::min(stroke.closest, error);
    return error;
  }
  Tally& tally = stroke.tally;
  tally.max_error = std::max(tally.max_error, error);
  if (!stroke.out && error > stroke.width / 2) {
    stroke.out = true;
    ++tally.excursions;
    if (left_at.size() < kMostLeftAt) left_at.push_back({p, sample.time, sample.stroke});
  } else if (stroke.out && error <= stroke.width / 4) {
    stroke.out = false;
  }
  if (last_counted && last.stroke == sample.stroke) {
    // Exact for an error that changes evenly between the two samples.
    const double way = glm::length(p - glm::dvec2(last.tip_P));
    tally.way += way;
    tally.error_way += way * (last_error + error) / 2;
    tally.square_way += way * (last_error * last_error + last_error * error + error * error) / 3;
  }
  return error;
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
  bool counted = false;
  if (sample.phase == TracePhase::kAir || sample.phase == TracePhase::kWay) {
    state.AddForce(state.air, sample);
  } else {
    Progress& stroke = state.strokes.at(sample.stroke);
    state.AddForce(stroke.tally, sample);
    state.AddLanding(stroke, sample);
    counted = sample.phase == TracePhase::kStroke && sample.in_contact;
    if (counted) state.last_error = state.AddError(stroke, sample);
  }
  state.last_counted = counted;
  state.last = sample;
  state.any = true;
}

TraceScore TraceScorer::Finish() const {
  std::vector<Tally> letters(state_->glyph_count);
  for (const Progress& stroke : state_->strokes) Include(letters[stroke.glyph], stroke.Closed());
  TraceScore score;
  Tally total = state_->air;
  for (const Tally& letter : letters) {
    score.letters.push_back(MetricsOf(letter));
    Include(total, letter);
  }
  score.total = MetricsOf(total);
  score.left_at = state_->left_at;
  return score;
}

}  // namespace moontrace
